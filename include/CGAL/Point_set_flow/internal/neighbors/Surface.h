// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_SURFACE_H
#define CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_SURFACE_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/neighbors/Neighbor_graph.h>

#include <cstddef>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// What is known of a surface besides its points, at one time of the flow.
struct Surface_state {
  Array<Vector_3> normals; ///< empty before the first tangent planes
  Array<double> noise;     ///< the standard deviation around each point; empty if not needed
  double spacing = 0.;
  double time = 0.; ///< 0 in the first step, 1 in the last

  Surface_estimate_3 at(std::size_t i) const
  {
    Surface_estimate_3 surface;
    surface.normals = normals.empty() ? nullptr : normals.data();
    surface.noise = noise.empty() ? 0. : noise[i];
    surface.spacing = spacing;
    surface.time = time;
    return surface;
  }
};

/// A view on points at one time of the flow, with their neighbors and what else is known
struct Surface {
  const Array<Point_3>& points;
  const Neighbor_graph& graph;
  double filter_width; ///< of the Gaussians, in neighborhood radii
  const Surface_state& state;

  std::size_t size() const { return points.size(); }
  Neighborhood_3 neighborhood(std::size_t i) const
  {
    return graph.neighborhood(points, i, filter_width, state.at(i));
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_SURFACE_H
