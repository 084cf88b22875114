// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FLOW_FLOW_RUN_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FLOW_FLOW_RUN_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/flows.h>
#include <CGAL/Point_set_flow/internal/flow/Flow_plan.h>
#include <CGAL/Point_set_flow/internal/flow/adapt_neighborhoods.h>
#include <CGAL/Point_set_flow/internal/flow/corrections.h>
#include <CGAL/Point_set_flow/internal/flow/noise_of_points.h>
#include <CGAL/Point_set_flow/internal/flow/prefilter.h>
#include <CGAL/Point_set_flow/internal/flow/Moves.h>
#include <CGAL/Point_set_flow/internal/flow/Relaxation.h>
#include <CGAL/Point_set_flow/internal/flow/Rest_reason.h>
#include <CGAL/Point_set_flow/internal/flow/Resting_points.h>
#include <CGAL/Point_set_flow/internal/flow/sides.h>
#include <CGAL/Point_set_flow/internal/flow/surface_results.h>
#include <CGAL/Point_set_flow/internal/flow/tangent_planes.h>
#include <CGAL/Point_set_flow/internal/neighbors/Block.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// The flow on one block (Table 1), from the reference to the result, and the relaxation after it.
template <typename ConcurrencyTag, typename Flow, typename Curvature>
class Flow_run {
  static constexpr bool uses_surface_estimate = Uses_surface_estimate<Curvature>::value;
  static constexpr bool is_corrected = Number_of_corrections<Curvature>::value > 0;

  const Flow_plan& m_plan;
  Block& m_block;
  const Flow& m_flow;
  const Curvature& m_curvature;
  Loops<ConcurrencyTag>& m_loops;
  Surface_state m_state;
  Vector_array m_spare; // for the next normals, or the moves of a step
  Moves m_moves;
  std::vector<double> m_moved; // see `moved()`
  Resting_points m_resting;
  Array<double> m_filtered_variation; // of the prefiltered surface, if the flow looks at it

public:
  Flow_run(const Flow_plan& plan, Block& block, const Flow& flow, const Curvature& curvature,
           Loops<ConcurrencyTag>& loops)
      : m_plan(plan), m_block(block), m_flow(flow), m_curvature(curvature),
        m_loops(loops), m_state{{}, {}, {}, {}, plan.parts, 0., {}}, m_moves(block.graph, m_spare)
  {
    m_state.part_of = std::move(block.part_of);
    if (!uses_surface_estimate)
      return;
    m_state.noise = noise_of_points(block.noise, m_state);
    block.noise = Given_noise(); // memory
    take_given_sides(m_state, block.sides);
    block.sides = Array<Vector_3>(); // memory
  }

  /// All steps.
  void operator()()
  {
    Array<Point_3> filtered;
    for (unsigned int t = 0; t < m_plan.number_of_iterations; ++t) {
      if (m_plan.update_period != 0 && t != 0 && t % m_plan.update_period == 0) // section 3.2
        m_moves.update_reference(t + 1 == m_plan.number_of_iterations);
      m_state.time = t == 0 ? 0. : t / (m_plan.number_of_iterations - 1.);

      if (m_plan.is_prefiltered) {
        m_loops.begin_stage(stage_costs::prefilter);
        prefilter(m_block.points, m_block.graph, m_plan.filter_width, filtered, m_loops);
        m_filtered_variation.resize(filtered.size());
        m_loops.begin_stage(stage_costs::planes);
        const auto take = [&](std::size_t i, const Tangent_plane_3& plane) {
          m_filtered_variation[i] = plane.variation;
        };
        find_tangent_planes(surface(filtered), m_curvature, take, m_loops);
      }
      if (uses_surface_estimate) {
        find_planes();
        if (t == 0)
          adapt_neighborhoods(m_block, m_state, m_plan, m_curvature, m_loops);
      }
      if (t == 0)
        start_moves();
      step(); // also if nothing moves: whether that is so depends on where blocks end
    }
    if (m_plan.number_of_iterations == 0)
      start_moves();
    m_moved = last_distances(m_moves, m_block);
    m_moves.finish();
    if constexpr (is_corrected)
      if (m_plan.number_of_corrections > 0) {
        m_state.residuals = m_moves.residuals(m_state.normals);
        correct(
            m_block.points, m_block.graph, m_state, m_curvature,
            [&](std::size_t i) { return rest_reason(i) != Rest_reason::OTHER; },
            [&](std::size_t i, const Vector_3& move) {
              m_block.points[i] = m_block.points[i] + move;
              m_moves.add(i, move);
            },
            m_loops);
      }
    if (m_plan.number_of_relaxation_steps != 0)
      relax_points();
  }

  /// How far the points moved in the last step; see `last_distances()`
  const std::vector<double>& moved() const { return m_moved; }

  /// How far the points are from their reference points; see `unit_of_moves()`
  Array<Compact_vector_3>&& take_moves() { return m_moves.take(); }

  /// Why a point of the block did not move, if it did not
  Rest_reason rest_reason(std::size_t i) const
  {
    if (m_block.is_constrained(i))
      return Rest_reason::CONSTRAINED;
    if (m_plan.number_of_iterations == 0 || m_plan.step_length == 0.)
      return Rest_reason::OTHER;
    if (m_block.graph.size(i) < 2 || is_isolated(i))
      return Rest_reason::ISOLATED;
    if (uses_surface_estimate && !(m_state.noise[i] > 0.f))
      return Rest_reason::NO_NOISE;
    return Rest_reason::OTHER;
  }

  /// The normals of the points where they are now; null vectors where there is no plane.
  Array<Vector_3> find_normals()
  {
    // Without noise, near neighbors are more informative, and the strict weights of the last step
    // would only reproduce the normals of the step before.
    const double narrowing = uses_surface_estimate ? .5 : 1.;
    m_state.time = 0.;
    m_loops.begin_stage(stage_costs::planes);
    return normals_of(surface(m_block.points, narrowing), m_curvature, m_loops);
  }

  /// The feature strength of the points where they are now
  Array<double> find_feature_strength()
  {
    m_loops.begin_stage(stage_costs::planes);
    return feature_strength_of(surface(m_block.points), m_plan.feature_diffusivity, m_loops);
  }

private:
  void relax_points()
  {
    // without noise, the planes would be those of the first step, which are blunt at creases
    for (float& noise : m_state.noise)
      noise = (std::max)(noise, .1f);
    const Array<Vector_3> normals = find_normals();
    m_state.normals.assign(normals);
    const Array<Point_3> start = m_block.points;
    relax_along_surface(
        surface(start), m_plan.number_of_relaxation_steps,
        [&](std::size_t i) { return may_move(i); }, m_block.points, m_loops);
    for (std::size_t i = 0; i < start.size(); ++i)
      m_moves.add(i, m_block.points[i] - start[i]);
  }

  void start_moves()
  {
    m_moves.start(m_block.points, m_block.reference);
    m_block.reference = Array<Point_3>(); // memory
    if (uses_surface_estimate)
      m_resting.find(m_block.graph, m_state.noise.size(),
                     [&](std::size_t i) { return is_at_rest(i); });
  }

  Surface surface(const Array<Point_3>& points, double narrowing = 1.) const
  {
    return {points, m_block.graph, m_state, narrowing};
  }

  /// The tangent planes of the points where they are now
  void find_planes()
  {
    m_loops.begin_stage(stage_costs::planes);
    if (!m_resting.empty())
      m_spare = m_state.normals;
    m_spare.resize(m_block.points.size());
    m_state.variations.resize(m_block.points.size());
    find_tangent_planes(
        surface(m_block.points), m_curvature,
        [&](std::size_t i) { return m_resting.needs_plane(i); },
        [&](std::size_t i, const Tangent_plane_3& plane) {
          m_spare[i] = plane.normal;
          m_state.variations[i] = float(plane.variation);
        },
        m_loops);
    m_state.normals.swap(m_spare);
  }

  bool may_move(std::size_t i) const { return !m_block.is_constrained(i) && !is_isolated(i); }

  /// Whether a point is where it was measured, and has no noise: it stays in all steps.
  bool is_at_rest(std::size_t i) const
  {
    return m_plan.may_rest && !(m_state.noise[i] > 0.f) && m_moves.from_reference(i) == NULL_VECTOR;
  }

  bool is_isolated(std::size_t i) const { return surface(m_block.points).is_isolated(i); }

  /// One explicit step: \f$u \leftarrow u + s\,\partial u / \partial t\f$, for all points at once
  void step()
  {
    const Surface before = surface(m_block.points);
    m_loops.begin_stage(stage_costs::step, 2);
    m_moves.begin_step();
    m_loops.for_each_chunk(before.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        m_moves.set(i, may_move(i) && !is_at_rest(i)
                           ? motion(before, i) * (m_plan.step_length / m_plan.unit)
                           : Vector_3(NULL_VECTOR));
    });
    m_loops.for_each_chunk(before.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        m_block.points[i] = m_block.points[i] + m_moves[i];
    });
  }

  /// \f$\partial u / \partial t\f$, in the unit of the data
  Vector_3 motion(const Surface& before, std::size_t i) const
  {
    const Neighborhood_3 neighborhood = before.neighborhood(i);
    const Tangent_plane_3 plane = // without memory for those of neighbors, if they are not used
        uses_surface_estimate ? m_state.plane(i) : tangent_plane_of(neighborhood, m_curvature);
    const double curvature =
        neighborhood.size() >= 2 ? m_curvature.directional_curvature(neighborhood, plane) : 0.;
    return m_flow({plane.normal, curvature * m_plan.unit, plane.variation,
                   m_plan.is_prefiltered ? m_filtered_variation[i] : plane.variation,
                   -m_moves.from_reference(i) * m_plan.unit},
                  m_state.parameters(i).diffusivity);
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FLOW_FLOW_RUN_H
