// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FLOW_SURFACE_RESULTS_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FLOW_SURFACE_RESULTS_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/Covariance_curvature.h>
#include <CGAL/Point_set_flow/internal/flow/tangent_planes.h>

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// The normals of the points of a surface; null vectors where there is no plane.
template <typename ConcurrencyTag, typename Curvature>
Array<Vector_3> normals_of(const Surface& surface, const Curvature& curvature,
                           Loops<ConcurrencyTag>& loops)
{
  Array<Vector_3> normals(surface.size());
  find_tangent_planes(
      surface, curvature,
      [&](std::size_t i, const Tangent_plane_3& plane) {
        const double squared = plane.normal.squared_length(); // it may be a compact one
        normals[i] = squared > 0. ? plane.normal / std::sqrt(squared) : plane.normal;
      },
      loops);
  return normals;
}

/// \f$1 - g\f$ of the surface variation, Eq. (2), of the points of a surface, with g 1/2 at a crease of the
/// sharpness angle if the caller gave no K
template <typename ConcurrencyTag>
Array<double> feature_strength_of(const Surface& surface, const Diffusivity& diffusivity,
                                  Loops<ConcurrencyTag>& loops)
{
  Array<double> strength(surface.size());
  find_tangent_planes(
      surface, Covariance_curvature(),
      [&](std::size_t i, const Tangent_plane_3& plane) {
        strength[i] = 1. - diffusivity(plane.variation);
      },
      loops);
  return strength;
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FLOW_SURFACE_RESULTS_H
