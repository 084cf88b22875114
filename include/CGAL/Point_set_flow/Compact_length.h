// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_COMPACT_LENGTH_H
#define CGAL_POINT_SET_FLOW_COMPACT_LENGTH_H

#include <CGAL/license/Point_set_flow.h>

#include <cstdint>
#include <cstring>
#include <limits>

namespace CGAL {
namespace Point_set_flow {

/// \ingroup PkgPointSetFlowCurvature
/// A length in four bytes, to save memory: in the range of `double`, which exceeds that of `float`, and with six digits.
/// It is rounded up, so that what is as far away as the length is not farther.
class Compact_length {
  static_assert(std::numeric_limits<double>::is_iec559, "the exponent is in the upper bits");
  static constexpr int left_out = 31; // bits of the mantissa; the sign is left out, too
  std::uint32_t m_bits = 0;

public:
  /// 0
  Compact_length() = default;
  /// rounds a length up
  /// \pre it is not negative
  explicit Compact_length(double length)
  {
    std::uint64_t bits;
    std::memcpy(&bits, &length, sizeof bits);
    const std::uint64_t below = (std::uint64_t(1) << left_out) - 1;
    m_bits = static_cast<std::uint32_t>((bits + below) >> left_out);
  }
  /// the length
  double value() const
  {
    const std::uint64_t bits = std::uint64_t(m_bits) << left_out;
    double length;
    std::memcpy(&length, &bits, sizeof length);
    return length;
  }
};

} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_COMPACT_LENGTH_H
