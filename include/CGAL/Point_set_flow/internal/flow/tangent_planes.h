// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FLOW_TANGENT_PLANES_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FLOW_TANGENT_PLANES_H

#include <CGAL/Point_set_flow/Curvature_defaults.h>
#include <CGAL/Point_set_flow/internal/neighbors/Neighbor_graph.h>
#include <CGAL/Point_set_flow/internal/neighbors/Surface.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// The tangent plane of each point of a surface, with the surface variation, Eq. (2); of the
/// prefiltered surface this is \f$|\kappa_H(G_\sigma \times u)|\f$. Points without at least two
/// neighbors have none, and keep the normals that they have.
/// \param normals receives the normals; null if nobody wants them
template <typename ConcurrencyTag, typename Curvature>
void find_tangent_planes(const Array<Point_3>& surface, const Neighbor_graph& graph,
                         double filter_width, const Surface_state& state,
                         const Curvature& curvature, Array<Vector_3>* normals,
                         Array<double>& variation, Progress& progress, double work)
{
  for_each_block<ConcurrencyTag>(
      surface.size(), progress, work, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          const Neighborhood_3 near = graph.neighborhood(surface, i, filter_width, state.at(i));
          const bool has_plane = near.size() >= 2;
          const Tangent_plane_3 plane =
              has_plane ? curvature.tangent_plane(near) : Tangent_plane_3{NULL_VECTOR, 0.};
          variation[i] = plane.variation;
          if (normals)
            (*normals)[i] = plane.normal;
        }
      });
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FLOW_TANGENT_PLANES_H
