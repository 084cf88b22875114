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

} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_TANGENT_PLANE_3_H
