// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_ORDER_MORTON_CURVE_H
#define CGAL_POINT_SET_FLOW_INTERNAL_ORDER_MORTON_CURVE_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/Core_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

// A Morton curve through all of space, with every digit of the coordinates: the bits of x, y and z
// alternate. It is the same whatever points there are.

/// The bits of a coordinate: the sign and \f$m\,2^{shift}\f$, in units of the smallest number
struct Coordinate_bits {
  bool is_negative;
  std::uint64_t m;
  int shift;

  explicit Coordinate_bits(double c) : is_negative(c < 0.)
  {
    static_assert(sizeof m == sizeof c, "coordinates are doubles of IEEE 754");
    std::memcpy(&m, &c, sizeof m);
    const int exponent = int(m >> 52 & 0x7ff);
    m &= (std::uint64_t(1) << 52) - 1;
    if (exponent != 0)
      m |= std::uint64_t(1) << 52;
    shift = (std::max)(exponent, 1) - 1;
  }

  /// The place of the highest bit; -1 for 0
  int highest() const { return m == 0 ? -1 : shift + std::ilogb(double(m)); }

  /// The place of the highest bit in which two coordinates differ, beyond all others if it is the sign; -1
  /// if they are equal
  static int highest_difference(const Coordinate_bits& a, const Coordinate_bits& b)
  {
    const int sign = 1 << 12;
    if (a.is_negative != b.is_negative)
      return sign;
    if (a.shift != b.shift) // the larger one is no subnormal number
      return (std::max)(a.shift, b.shift) + 52;
    return a.m == b.m ? -1 : a.shift + std::ilogb(double(a.m ^ b.m));
  }
};

/// The most significant digit in which two points differ: the larger it is, the larger is the smallest cell of
/// the curve that holds both. -1 if they are equal.
inline int morton_difference(const Point_3& p, const Point_3& q)
{
  int most = -1;
  for (int d = 0; d < 3; ++d)
    if (p[d] != q[d]) {
      const int digit =
          Coordinate_bits::highest_difference(Coordinate_bits(p[d]), Coordinate_bits(q[d]));
      most = (std::max)(most, 3 * digit + d);
    }
  return most;
}

/// Whether one of two points comes before the other on the curve; neither does if they are equal.
inline bool is_before_on_morton_curve(const Point_3& p, const Point_3& q)
{
  const int difference = morton_difference(p, q);
  return difference >= 0 && p[difference % 3] < q[difference % 3];
}

/// A grid in which the points of a box do not share one cell, with its cells in the order of the curve.
class Morton_cells {
  static constexpr int digits = 20; // besides the sign
  int m_lowest = 0;                 // the place of the bit that is the last digit

public:
  /// \pre the corners of the box differ
  Morton_cells(const std::array<double, 3>& low, const std::array<double, 3>& high)
  {
    int highest = -1, highest_bit = -1;
    bool has_both_signs = false;
    for (std::size_t d = 0; d < 3; ++d) {
      const Coordinate_bits a(low[d]), b(high[d]);
      has_both_signs = has_both_signs || a.is_negative != b.is_negative;
      highest = (std::max)(highest, Coordinate_bits::highest_difference(a, b));
      highest_bit = (std::max)({highest_bit, a.highest(), b.highest()});
    }
    m_lowest = (has_both_signs ? highest_bit : highest) - (digits - 1);
  }

  /// The number of the cell that holds a point of the box
  std::uint64_t number(const Point_3& p) const
  {
    std::uint64_t number = 0;
    for (int d = 0; d < 3; ++d)
      number |= spread(place(Coordinate_bits(p[d]))) << d;
    return number;
  }

private:
  std::uint64_t place(const Coordinate_bits& c) const
  {
    const std::uint64_t mask = (std::uint64_t(1) << digits) - 1;
    const int shift = m_lowest - c.shift;
    const std::uint64_t magnitude = (shift >= 64       ? 0
                                     : shift >= 0      ? c.m >> shift
                                     : shift > -digits ? c.m << -shift
                                                       : 0) &
                                    mask;
    return c.is_negative ? magnitude ^ mask : magnitude | std::uint64_t(1) << digits;
  }

  /// Moves the lowest 21 bits three places apart.
  static std::uint64_t spread(std::uint64_t x)
  {
    x = (x | x << 32) & 0x001f00000000ffff;
    x = (x | x << 16) & 0x001f0000ff0000ff;
    x = (x | x << 8) & 0x100f00f00f00f00f;
    x = (x | x << 4) & 0x10c30c30c30c30c3;
    return (x | x << 2) & 0x1249249249249249;
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_ORDER_MORTON_CURVE_H
