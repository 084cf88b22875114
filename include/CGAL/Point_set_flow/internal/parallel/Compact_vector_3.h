// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_PARALLEL_COMPACT_VECTOR_3_H
#define CGAL_POINT_SET_FLOW_INTERNAL_PARALLEL_COMPACT_VECTOR_3_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/Core_kernel.h>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// A vector in single precision, to save memory
struct Compact_vector_3 {
  float x = 0.f, y = 0.f, z = 0.f;

  Compact_vector_3() = default;
  explicit Compact_vector_3(const Vector_3& v) : x(float(v.x())), y(float(v.y())), z(float(v.z()))
  {}
  Vector_3 vector() const { return Vector_3(double(x), double(y), double(z)); }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_PARALLEL_COMPACT_VECTOR_3_H
