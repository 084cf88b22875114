// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FLOW_CORRECTIONS_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FLOW_CORRECTIONS_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/flow/model_traits.h>
#include <CGAL/Point_set_flow/internal/neighbors/Surface.h>
#include <CGAL/Point_set_flow/internal/parallel/stage_costs.h>

#include <cstddef>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// Moves the result of the flow along the normals of its last step, by what the estimator tells from the
/// residuals. In each round all points move at once.
/// \param points where they are
/// \param state has the residuals
/// \param is_fixed tells by its index whether a point stays
/// \param move called as `move(i, vector)`, moves a point
template <typename ConcurrencyTag, typename Curvature, typename Is_fixed, typename Move>
void correct(const Array<Point_3>& points, const Neighbor_graph& graph, Surface_state& state,
             const Curvature& curvature, const Is_fixed& is_fixed, const Move& move,
             Loops<ConcurrencyTag>& loops)
{
  const std::size_t n = points.size();
  const Surface surface{points, graph, state};
  Array<float> movements(n);
  for (unsigned int round = 0; round < Number_of_corrections<Curvature>::value; ++round) {
    loops.begin_stage(stage_costs::network, 2);
    loops.for_each_chunk(n, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        Neighborhood_3 neighborhood = surface.neighborhood(i);
        neighborhood.surface_estimate().radii = graph.radii();
        movements[i] = is_fixed(i) || !(graph.radius(i) > 0.)
                           ? 0.f
                           : float(curvature.correction(neighborhood, round) / graph.radius(i));
      }
    });
    loops.for_each_chunk(n, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        move(i, double(movements[i]) * graph.radius(i) * state.normals[i].vector());
        state.residuals[i] -= movements[i];
      }
    });
  }
  state.residuals = Array<float>(); // memory
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FLOW_CORRECTIONS_H
