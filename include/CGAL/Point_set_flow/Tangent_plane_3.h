// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_TANGENT_PLANE_3_H
#define CGAL_POINT_SET_FLOW_TANGENT_PLANE_3_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/Core_kernel.h>

namespace CGAL {
namespace Point_set_flow {

/// \ingroup PkgPointSetFlowCurvature
/// The plane through a point that an estimator fits to its neighborhood.
struct Tangent_plane_3 {
  /// a unit vector; its orientation is arbitrary
  Vector_3 normal;
  /// the surface variation: without unit, at least 0, and 0 where the surface is flat
  double variation;
};

/// \ingroup PkgPointSetFlowCurvature
/// A tangent plane in single precision. Those of all points are kept in this form: four neighbors at a time are
/// loaded from it.
struct Compact_tangent_plane_3 {
  float x = 0.f;         /*!< x of the normal */
  float y = 0.f;         /*!< y */
  float z = 0.f;         /*!< z */
  float variation = 0.f; ///< see `Tangent_plane_3`
  /// a null normal
  Compact_tangent_plane_3() = default;
  /// rounds a tangent plane
  Compact_tangent_plane_3(const Vector_3& normal, double variation_ = 0.)
      : x(float(normal.x())), y(float(normal.y())), z(float(normal.z())),
        variation(float(variation_))
  {}
  Vector_3 normal() const { return Vector_3(double(x), double(y), double(z)); } ///< the normal
};

} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_TANGENT_PLANE_3_H
