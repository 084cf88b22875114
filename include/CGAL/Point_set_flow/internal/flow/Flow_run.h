// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FLOW_FLOW_RUN_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FLOW_FLOW_RUN_H

#include <CGAL/Point_set_flow/Covariance_curvature.h>
#include <CGAL/Point_set_flow/internal/flow/Flow_plan.h>
#include <CGAL/Point_set_flow/internal/flow/flow_step.h>
#include <CGAL/Point_set_flow/internal/noise/two_sheets.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// The flow on one piece (Table 1), from the reference to the result.
template <typename ConcurrencyTag, typename Flow, typename Curvature>
class Flow_run {
  typedef Flow_plan<Flow, Curvature> Plan;
  static constexpr bool uses_normals = Plan::uses_normals, prefiltered = Plan::prefiltered;

  const Plan& m_plan;
  Piece& m_piece;
  const Flow& m_flow;
  const Curvature& m_curvature;
  Progress& m_progress;
  double m_unit, m_share;
  Surface_state m_state;
  Array<Point_3> m_before; // the last step

public:
  /// \param unit the length of 1 in the piece, in the unit of the data
  /// \param share that of the piece in the progress
  Flow_run(const Plan& plan, Piece& piece, const Flow& flow, const Curvature& curvature,
           double unit, Progress& progress, double share)
      : m_plan(plan), m_piece(piece), m_flow(flow), m_curvature(curvature), m_progress(progress),
        m_unit(unit), m_share(share)
  {
    m_state.spacing = plan.noise_map.spacing();
    if (uses_normals)
      m_state.noise =
          plan.noise_map.noise_at(ConcurrencyTag(), piece.reference, progress, share * work::noise);
  }

  /// All steps.
  void operator()()
  {
    const std::size_t n = m_piece.reference.size();
    Array<double> variation(n);
    Array<Point_3> filtered;
    for (unsigned int t = 0; t < m_plan.number_of_iterations; ++t) {
      if (m_plan.update_period != 0 && t != 0 && t % m_plan.update_period == 0)
        m_piece.reference = m_piece.points; // section 3.2
      m_before = Array<Point_3>();          // memory: there are new normals first
      m_state.time = t == 0 ? 0. : t / (m_plan.number_of_iterations - 1.);

      if (prefiltered) {
        filtered.resize(n);
        prefilter<ConcurrencyTag>(m_piece.current_points(), m_piece.graph, m_plan.filter_width,
                                  filtered, m_progress, m_share * work::prefilter);
      }
      if (prefiltered || uses_normals) {
        Array<Vector_3> normals(uses_normals ? n : 0);
        find_tangent_planes<ConcurrencyTag>(prefiltered ? filtered : m_piece.current_points(),
                                            m_piece.graph, m_plan.filter_width, m_state,
                                            m_curvature, uses_normals ? &normals : nullptr,
                                            variation, m_progress, m_share * work::planes);
        m_state.normals.swap(normals);
      }
      if (uses_normals && t == 0)
        adapt_neighborhoods();

      start();
      m_before.resize(n);
      m_before.swap(m_piece.points);
      flow_step<ConcurrencyTag>(m_before, m_piece, m_plan.filter_width, m_state, m_curvature,
                                prefiltered || uses_normals ? &variation : nullptr, m_flow,
                                m_plan.diffusivity, m_plan.step_length, m_unit, m_progress,
                                m_share * work::step);
      if (m_before == m_piece.points) // nothing moves any more
        break;
    }
    start(); // without iterations
  }

  /// How far a point of the piece moved in the last step
  double moved(std::size_t i) const
  {
    return m_before.empty() ? 0. : std::sqrt(squared_distance(m_piece.points[i], m_before[i]));
  }

  /// The normals of the points where they are now; null vectors where there are less than two
  /// neighbors, and so no plane.
  Array<Vector_3> find_normals()
  {
    Array<Vector_3> normals(m_piece.points.size());
    Array<double> variation(m_piece.points.size());
    // Without the noise, nearer neighbors tell more, and the strict weights of the last step
    // would only hold on to the normals of the step before.
    const double width = uses_normals ? .5 * m_plan.filter_width : m_plan.filter_width;
    m_state.time = 0.;
    find_tangent_planes<ConcurrencyTag>(m_piece.points, m_piece.graph, width, m_state, m_curvature,
                                        &normals, variation, m_progress, m_share * work::planes);
    return normals;
  }

  /// \f$1 - g\f$ of the surface variation, Eq. (2), of the points where they are now, with g 1/2 at
  /// a crease of the sharpness angle if the caller gave no K
  Array<double> find_feature_strength()
  {
    Array<double> strength(m_piece.points.size());
    find_tangent_planes<ConcurrencyTag>(m_piece.points, m_piece.graph, m_plan.filter_width, m_state,
                                        Covariance_curvature(), nullptr, strength, m_progress,
                                        m_share * work::planes);
    for (double& x : strength)
      x = 1. - m_plan.without_noise(x);
    return strength;
  }

private:
  /// Gives the points a place of their own: memory, not before they move.
  void start()
  {
    if (!m_piece.points.empty())
      return;
    m_piece.points.resize(m_piece.reference.size());
    const auto copy = [&](std::size_t begin, std::size_t end) {
      std::copy(m_piece.reference.begin() + std::ptrdiff_t(begin),
                m_piece.reference.begin() + std::ptrdiff_t(end),
                m_piece.points.begin() + std::ptrdiff_t(begin));
    };
    for_each_block<ConcurrencyTag>(m_piece.points.size(), m_progress, 0., copy);
  }

  /// To thin parts and to noise that is not everywhere the same
  void adapt_neighborhoods()
  {
    const Array<std::uint32_t> sizes = find_thin_parts<ConcurrencyTag>(
        m_piece.current_points(), m_piece.graph, m_plan.filter_width, m_plan.defaults, m_state,
        m_progress, m_share * work::thin_parts);
    if (!m_plan.is_k_given)
      m_piece.graph.template shrink<ConcurrencyTag>(m_piece.reference, sizes, m_progress,
                                                    m_share * work::shrink);
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FLOW_FLOW_RUN_H
