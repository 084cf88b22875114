// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FLOW_SHEET_ROUNDS_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FLOW_SHEET_ROUNDS_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/flow/model_traits.h>
#include <CGAL/Point_set_flow/internal/neighbors/Surface.h>
#include <CGAL/Point_set_flow/internal/parallel/stage_costs.h>

#include <cstddef>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// Asks the estimator whether the neighbors of each point are those of two sheets, in rounds: each one sees what
/// the one before found of the neighbors.
/// \param points with normals, which no step has moved yet
/// \param state has the excess around each point; has what was found, after that
template <typename ConcurrencyTag, typename Curvature>
void find_sheets(const Array<Point_3>& points, const Neighbor_graph& graph, Surface_state& state,
                 const Curvature& curvature, Loops<ConcurrencyTag>& loops)
{
  const std::size_t n = points.size();
  const Surface surface{points, graph, state};
  Array<Sheet_evidence> found(n);
  for (unsigned int round = 0; round < Number_of_sheet_rounds<Curvature>::value; ++round) {
    loops.begin_stage(stage_costs::network);
    loops.for_each_chunk(n, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const Neighborhood_3 neighborhood = surface.neighborhood(i);
        const bool is_surface =
            neighborhood.size() >= 2 && neighborhood.radius() > 0. && neighborhood.noise() > 0.;
        found[i] = state.sheets[i];
        if (is_surface) {
          const Sheet_evidence evidence = curvature.find_sheets(neighborhood, round);
          found[i].two_sheets = evidence.two_sheets;
          found[i].side = evidence.side;
        }
      }
    });
    found.swap(state.sheets);
  }
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FLOW_SHEET_ROUNDS_H
