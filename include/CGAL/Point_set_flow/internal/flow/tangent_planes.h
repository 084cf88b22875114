// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FLOW_TANGENT_PLANES_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FLOW_TANGENT_PLANES_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/Tangent_plane_3.h>
#include <CGAL/Point_set_flow/internal/neighbors/Surface.h>

#include <cstddef>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// The tangent plane of a point; none, a null vector, if it has fewer than two neighbors.
template <typename Curvature>
Tangent_plane_3 tangent_plane_of(const Neighborhood_3& neighborhood, const Curvature& curvature)
{
  return neighborhood.size() >= 2 ? curvature.tangent_plane(neighborhood)
                                  : Tangent_plane_3{NULL_VECTOR, 0.};
}

/// The tangent plane of each point of a surface, with the surface variation, Eq. (2); of the
/// prefiltered surface this is \f$|\kappa_H(G_\sigma \times u)|\f$.
/// \param is_needed tells by its index whether the plane of a point is needed
/// \param take called for each of these points as `take(i, plane)`, with the normal oriented to the side that is known
template <typename ConcurrencyTag, typename Curvature, typename Is_needed, typename Take>
void find_tangent_planes(const Surface& surface, const Curvature& curvature,
                         const Is_needed& is_needed, const Take& take, Loops<ConcurrencyTag>& loops)
{
  loops.for_each_chunk(surface.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (!is_needed(i))
        continue;
      const Tangent_plane_3 plane = tangent_plane_of(surface.neighborhood(i), curvature);
      take(i, Tangent_plane_3{surface.state.oriented(i, plane.normal), plane.variation});
    }
  });
}
template <typename ConcurrencyTag, typename Curvature, typename Take>
void find_tangent_planes(const Surface& surface, const Curvature& curvature, const Take& take,
                         Loops<ConcurrencyTag>& loops)
{
  find_tangent_planes(
      surface, curvature, [](std::size_t) { return true; }, take, loops);
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FLOW_TANGENT_PLANES_H
