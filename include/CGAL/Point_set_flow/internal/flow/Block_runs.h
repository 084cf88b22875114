// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FLOW_BLOCK_RUNS_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FLOW_BLOCK_RUNS_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/flow/Flow_run.h>
#include <CGAL/Point_set_flow/internal/neighbors/Block.h>

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// What the caller asks for besides the points
struct Wanted_results {
  bool normals, feature_strength;
  bool limited_moves; ///< no point may leave its neighborhood
};

/// The results for the distinct points.
struct Flow_result {
  Array<Compact_vector_3> moves;   ///< from the reference points, in `unit()`
  Array<Compact_length> radii;     ///< of the neighborhoods
  bool is_limited = false;         ///< whether no point may leave its neighborhood
  Array<Vector_3> normals;         ///< empty if not wanted; null vectors where there is no plane
  Array<double> feature_strength;  ///< empty if not wanted
  Array<Rest_reason> rest_reasons; ///< of those that did not move
  double moved = 0.;               ///< the mean distance in the last step

  /// The length of 1 of the moves of a point
  double unit(std::size_t i) const { return unit_of_moves(radii[i].value()); }

  /// \param n the number of points in all blocks
  template <typename T>
  static void append(Array<T>& to, Array<T>&& of_block, const Block& block, std::size_t n)
  {
    if (block.interior.empty()) {
      to = std::move(of_block);
      return;
    }
    to.reserve(n); // to grow would take twice the memory
    for (const std::uint32_t i : block.interior)
      to.push_back(of_block[i]);
  }
};

/// The cost of all stages, for the progress
/// \param likely_size see `likely_size()`
template <typename Flow, typename Curvature>
double total_cost(const Flow_parameters& parameters, const Flow& flow, const Curvature&,
                  const Wanted_results& wanted, std::size_t likely_size)
{
  namespace costs = stage_costs;
  const unsigned int steps =
      parameters.number_of_iterations.value_or(Defaults_of<Curvature>::get().number_of_iterations);
  const bool uses_surface_estimate = Uses_surface_estimate<Curvature>::value;
  const double planes = uses_surface_estimate  ? costs::planes
                        : uses_prefilter(flow) ? costs::prefilter + costs::planes
                                               : 0.;
  return costs::analysis + (likely_size == 0 ? costs::graph : costs::adapt) +
         (uses_surface_estimate ? costs::sheets + costs::shrink : 0.) +
         steps * (planes + costs::step) +
         (Number_of_sheet_rounds<Curvature>::value +
          (is_correctable(flow) ? Number_of_corrections<Curvature>::value : 0)) *
             costs::network +
         (parameters.number_of_relaxation_steps == 0
              ? 0.
              : costs::planes + parameters.number_of_relaxation_steps * costs::relaxation) +
         (int(wanted.normals) + int(wanted.feature_strength)) * costs::planes;
}

/// The flow on a point set, block by block.
template <typename ConcurrencyTag, typename Flow, typename Curvature>
class Block_runs {
  const Flow_plan& m_plan;
  const Flow& m_flow;
  const Curvature& m_curvature;
  const Wanted_results m_wanted;
  Loops<ConcurrencyTag>& m_loops;
  std::vector<double> m_moved; // see `Flow_run::moved()`
  Flow_result m_result;
  std::size_t m_number_of_points = 0; // of the result

public:
  Block_runs(const Flow_plan& plan, const Flow& flow, const Curvature& curvature,
             const Wanted_results& wanted, Loops<ConcurrencyTag>& loops)
      : m_plan(plan), m_flow(flow), m_curvature(curvature), m_wanted(wanted), m_loops(loops)
  {}

  /// Leaves of the points only where each input point went.
  Flow_result operator()(Analyzed_points& points, std::size_t block_size)
  {
    m_number_of_points = points.buffer().size();
    if (m_number_of_points <= block_size) {
      adapt_graph(points);
      Block all = take_all(points.buffer(), points.part_of(), std::move(points.graph()));
      points.forget_points();
      run(all);
    }
    else {
      run_in_turn(points, (block_size + chunk_size - 1) / chunk_size * chunk_size);
      points.forget_points();
    }
    return take_result();
  }

  /// Runs the flow on one block of points of which some may be missing.
  /// \param interior the sites of the block, ascending, which are those of the result
  /// \param is_certain see `cut_graph()`
  /// \return nothing if the result is not certain
  template <typename Is_certain>
  std::optional<Flow_result> run_one(Analyzed_points& points,
                                     const std::vector<std::uint32_t>& interior,
                                     const Is_certain& is_certain)
  {
    m_loops.begin_stage(stage_costs::graph);
    std::optional<Cut_graph> cut = cut_graph(points.tree(), m_plan.search, interior,
                                             m_plan.number_of_rings(), is_certain, m_loops);
    if (!cut)
      return std::nullopt;
    Block block = take_some(points.buffer(), points.part_of(), std::move(*cut));
    m_number_of_points = interior.size();
    points.forget_points();
    run(block);
    return take_result();
  }

private:
  /// To what is planned
  void adapt_graph(Analyzed_points& points) const
  {
    const bool has_graph = points.graph().number_of_points() != 0;
    m_loops.begin_stage(has_graph ? stage_costs::adapt : stage_costs::graph);
    if (has_graph)
      points.graph().adapt(points.tree(), m_plan.search, m_loops);
    else
      points.graph() = Neighbor_graph(points.tree(), m_plan.search, m_loops);
  }

  Flow_result take_result()
  {
    m_result.is_limited = m_wanted.limited_moves;
    m_result.moved =
        std::accumulate(m_moved.begin(), m_moved.end(), 0.) / double(m_number_of_points);
    return std::move(m_result);
  }

  void run_in_turn(Analyzed_points& points, std::size_t block_size)
  {
    points.forget_scales();
    for_each_cut(
        points.tree(), m_plan.search, block_size, m_plan.number_of_rings(),
        [&](Cut_graph&& cut, std::size_t, std::size_t) {
          Block block = take_some(points.buffer(), points.part_of(), std::move(cut));
          run(block);
        },
        m_loops);
  }

  void run(Block& block)
  {
    Flow_run<ConcurrencyTag, Flow, Curvature> flow(m_plan, block, m_flow, m_curvature, m_loops);
    flow();
    m_result.rest_reasons.reserve(m_number_of_points); // not earlier, to save memory
    m_moved.insert(m_moved.end(), flow.moved().begin(), flow.moved().end());
    for (std::size_t i = 0; i < block.interior_size(); ++i)
      m_result.rest_reasons.push_back(flow.rest_reason(block.interior_place(i)));
    const auto append = [&](auto& to, auto&& of_block) {
      Flow_result::append(to, std::move(of_block), block, m_number_of_points);
    };
    if (m_wanted.normals)
      append(m_result.normals, flow.find_normals());
    if (m_wanted.feature_strength)
      append(m_result.feature_strength, flow.find_feature_strength());
    append(m_result.moves, flow.take_moves());
    append(m_result.radii, block.graph.take_radii());
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FLOW_BLOCK_RUNS_H
