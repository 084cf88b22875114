// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_SURFACE_H
#define CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_SURFACE_H

#include <CGAL/Point_set_flow/Neighborhood_3.h>
#include <CGAL/Point_set_flow/internal/parallel/Array.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// What is known of the surface besides its points, at one time of the flow.
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

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_SURFACE_H
