// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FLOW_ADAPT_NEIGHBORHOODS_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FLOW_ADAPT_NEIGHBORHOODS_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/flow/Flow_plan.h>
#include <CGAL/Point_set_flow/internal/flow/sides.h>
#include <CGAL/Point_set_flow/internal/neighbors/Block.h>
#include <CGAL/Point_set_flow/internal/noise/two_sheets.h>
#include <CGAL/Point_set_flow/internal/parallel/stage_costs.h>

#include <cstddef>
#include <utility>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// Asks the estimator whether the neighbors of each point are those of two sheets, in rounds: each one sees what
/// the one before found of the neighbors.
/// \param deviations, moments of the distances from the tangent planes, in spacings; the moments are pooled
/// \param state has what was found, after that
template <typename ConcurrencyTag, typename Curvature>
void find_sheets(const Surface& surface, const Array<float>& deviations,
                 const Array<Compact_moments>& moments, Surface_state& state,
                 const Curvature& curvature, Loops<ConcurrencyTag>& loops)
{
  state.sheets.resize(surface.size());
  Array<Sheet_evidence> found(surface.size());
  for (unsigned int round = 0; round < Number_of_sheet_rounds<Curvature>::value; ++round) {
    loops.begin_stage(stage_costs::network);
    loops.for_each_chunk(surface.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        Neighborhood_3 neighborhood = surface.neighborhood(i);
        Surface_estimate_3& estimate = neighborhood.surface_estimate();
        estimate.deviation = double(deviations[i]) * estimate.spacing;
        estimate.excess = moments[i].moments().excess();
        const bool is_surface =
            neighborhood.size() >= 2 && neighborhood.radius() > 0. && neighborhood.noise() > 0.;
        found[i] = is_surface ? curvature.find_sheets(neighborhood, round) : state.sheets[i];
      }
    });
    found.swap(state.sheets);
  }
}

/// Adapts noise and neighborhoods to thin parts, and finds on which of two sheets points are, after the first
/// tangent planes.
template <typename ConcurrencyTag, typename Curvature>
void adapt_neighborhoods(Block& block, Surface_state& state, const Flow_plan& plan,
                         const Curvature& curvature, Loops<ConcurrencyTag>& loops)
{
  constexpr bool finds_sheets = Number_of_sheet_rounds<Curvature>::value > 0;
  loops.begin_stage(stage_costs::sheets, sheet_loops);
  const Surface surface{block.points, block.graph, state};
  Array<signed char> sides;
  Array<Compact_moments> moments = find_moments(surface, sides, loops);
  Array<float> deviations;
  if constexpr (finds_sheets) {
    deviations.reserve(moments.size());
    for (const Compact_moments& m : moments)
      deviations.push_back(float(m.deviation()));
  }
  pool(block.graph, moments, loops);
  if constexpr (finds_sheets)
    find_sheets(surface, deviations, moments, state, curvature, loops);
  deviations = Array<float>(); // memory
  const Sheets sheets = fit_sheets(surface, moments, std::move(sides), plan.defaults, state.noise,
                                   plan.is_noise_given, loops);
  state.sheets = Array<Sheet_evidence>(); // memory
  take_found_sides(state, sheets.sides);
  if (!plan.is_k_given) {
    loops.begin_stage(stage_costs::shrink);
    // by the distances at which they were searched
    block.graph.shrink(block.reference.empty() ? block.points : block.reference, sheets.sizes,
                       loops);
  }
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FLOW_ADAPT_NEIGHBORHOODS_H
