// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_FILES_SCAN_FRAME_H
#define POINT_FILES_SCAN_FRAME_H

#include <array>
#include <cstddef>

namespace point_files {

/// Where a scan is: its points are in coordinates of their own, which an affine map takes to those that
/// all scans share. A point at the origin is none and stays there, as one that is not finite.
class Scan_frame {
public:
  typedef std::array<double, 3> Triple;

private:
  std::array<Triple, 3> m_axes, m_inverse; // images of the unit vectors, there and back
  Triple m_translation, m_position;

public:
  /// \param position of the scanner, in the shared coordinates; NaN if it is not known
  ///
  /// Throws `std::runtime_error` if the map has no inverse or is not finite.
  Scan_frame(const std::array<Triple, 3>& axes, const Triple& translation, const Triple& position);

  /// The same of points that are in the shared coordinates
  explicit Scan_frame(const Triple& position);

  const Triple& position() const { return m_position; }

  Triple to_shared(const Triple& p) const;
  Triple to_own(const Triple& p) const;
};

} // namespace point_files

#endif // POINT_FILES_SCAN_FRAME_H
