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

/// The tangent plane of each point of a surface, with the surface variation, Eq. (2); of the
/// prefiltered surface this is \f$|\kappa_H(G_\sigma \times u)|\f$. Points without at least two
/// neighbors have none: null vectors.
/// \param normals receives the normals; null if not needed
template <typename ConcurrencyTag, typename Curvature>
void find_tangent_planes(const Surface& surface, const Curvature& curvature,
                         Array<Vector_3>* normals, Array<double>& variation,
                         Loops<ConcurrencyTag>& loops)
{
  loops.for_each_chunk(surface.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Neighborhood_3 near = surface.neighborhood(i);
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
