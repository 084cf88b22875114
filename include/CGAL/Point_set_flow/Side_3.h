// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_SIDE_3_H
#define CGAL_POINT_SET_FLOW_SIDE_3_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/Core_kernel.h>

#include <cmath>
#include <cstdint>

namespace CGAL {
namespace Point_set_flow {

/// \ingroup PkgPointSetFlowCurvature
/// The side of a surface on which a point was measured: a direction, accurate to half a degree, to save memory.
class Side_3 {
  std::int8_t m_x = 0, m_y = 0, m_z = 0;
  bool m_is_known = false;

public:
  /// a side that is not known
  Side_3() = default;
  /// \param direction a vector to the side, of any length; if it is a null vector, the side is not known
  explicit Side_3(const Vector_3& direction)
  {
    const double length = std::sqrt(direction.squared_length());
    if (!(length > 0.))
      return;
    m_x = rounded(direction.x() / length);
    m_y = rounded(direction.y() / length);
    m_z = rounded(direction.z() / length);
    m_is_known = true;
  }
  bool is_known() const { return m_is_known; } ///< whether the side is known
  /// a vector to the side, of a length near to 1; a null vector if it is not known
  Vector_3 vector() const { return Vector_3(m_x, m_y, m_z) / 127.; }

private:
  static std::int8_t rounded(double x) { return static_cast<std::int8_t>(std::lround(127. * x)); }
};

} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_SIDE_3_H
