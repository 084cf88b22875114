// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_COMPACT_VECTOR_3_H
#define CGAL_POINT_SET_FLOW_COMPACT_VECTOR_3_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/Core_kernel.h>

namespace CGAL {
namespace Point_set_flow {

/// \ingroup PkgPointSetFlowCurvature
/// A vector in single precision, to save memory. The normals of all points are kept in this form: several neighbors
/// at a time are loaded from it.
struct Compact_vector_3 {
  float x = 0.f; /*!< x */
  float y = 0.f; /*!< y */
  float z = 0.f; /*!< z */
  /// a null vector
  Compact_vector_3() = default;
  /// rounds a vector
  Compact_vector_3(const Vector_3& v) : x(float(v.x())), y(float(v.y())), z(float(v.z())) {}
  /// the vector
  Vector_3 vector() const { return Vector_3(double(x), double(y), double(z)); }
};

} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_COMPACT_VECTOR_3_H
