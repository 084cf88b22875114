// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_COMPACT_LENGTH_H
#define CGAL_POINT_SET_FLOW_COMPACT_LENGTH_H

#include <CGAL/license/Point_set_flow.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

namespace CGAL {
namespace Point_set_flow {

/// \ingroup PkgPointSetFlowCurvature
/// A length in six bytes, to save memory: in the range of `double`, which exceeds that of `float`, and with eleven digits.
/// It is rounded up, so that what is as far away as the length is not farther.
class Compact_length {
  static_assert(std::numeric_limits<double>::is_iec559, "the exponent is in the upper bits");
  static constexpr int left_out = 15; // bits of the mantissa; the sign is left out, too
  std::array<std::uint16_t, 3> m_parts = {};

public:
  /// how much is rounded up at most, relative to the length
  static constexpr double rounding = 1. / double(std::uint64_t(1) << (52 - left_out));

  /// 0
  Compact_length() = default;
  /// rounds a length up
  /// \pre it is not negative
  explicit Compact_length(double length)
  {
    std::uint64_t bits;
    std::memcpy(&bits, &length, sizeof bits);
    bits = (bits + (std::uint64_t(1) << left_out) - 1) >> left_out;
    for (std::size_t i = 0; i < m_parts.size(); ++i)
      m_parts[i] = static_cast<std::uint16_t>(bits >> (16 * i));
  }
  /// the length
  double value() const
  {
    const std::uint64_t bits =
        (std::uint64_t(m_parts[2]) << 32 | std::uint64_t(m_parts[1]) << 16 | m_parts[0])
        << left_out;
    double length;
    std::memcpy(&length, &bits, sizeof length);
    return length;
  }
};

} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_COMPACT_LENGTH_H
