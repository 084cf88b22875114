// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FITTING_LANES_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FITTING_LANES_H

#include <CGAL/Point_set_flow/Core_kernel.h>

#include <Eigen/Core>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// Numbers of two neighbors, computed at once: one register on any x86-64 or ARM processor.
typedef Eigen::Array2d Lanes;

struct Lanes_3 {
  Lanes x, y, z;

  Lanes_3(const Vector_3& a, const Vector_3& b) : x(a.x(), b.x()), y(a.y(), b.y()), z(a.z(), b.z())
  {}
  /// from one point to two
  Lanes_3(const Point_3& from, const Point_3& a, const Point_3& b)
      : x(Lanes(a.x(), b.x()) - from.x()), y(Lanes(a.y(), b.y()) - from.y()),
        z(Lanes(a.z(), b.z()) - from.z())
  {}

  Lanes operator*(const Vector_3& v) const { return x * v.x() + y * v.y() + z * v.z(); }
  Lanes operator*(const Lanes_3& v) const { return x * v.x + y * v.y + z * v.z; }
  Lanes squared_length() const { return *this * *this; }
};

/// \f$(1 - x/32)^{32}\f$, and 0 from 32 on: close to \f$e^{-x}\f$, at a tenth of its cost. A weight is
/// none the worse for it.
inline Lanes bell(const Lanes& x)
{
  Lanes b = (1. - x * (1. / 32.)).max(0.);
  b *= b;
  b *= b;
  b *= b;
  b *= b;
  return b * b;
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FITTING_LANES_H
