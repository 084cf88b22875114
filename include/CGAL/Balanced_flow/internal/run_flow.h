// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BALANCED_FLOW_INTERNAL_RUN_FLOW_H
#define CGAL_BALANCED_FLOW_INTERNAL_RUN_FLOW_H

#include <CGAL/Balanced_flow/Covariance_curvature.h>
#include <CGAL/Balanced_flow/internal/Options.h>
#include <CGAL/Balanced_flow/internal/find_scale.h>
#include <CGAL/Balanced_flow/internal/flow_step.h>
#include <CGAL/Balanced_flow/internal/local_noise.h>
#include <CGAL/Balanced_flow/internal/model_traits.h>
#include <CGAL/Balanced_flow/internal/prefilter.h>
#include <CGAL/Balanced_flow/internal/tangent_planes.h>
#include <CGAL/Balanced_flow/internal/thin_parts.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// What the stages cost relative to each other, for the progress.
namespace work {
constexpr double order = 2., scale = .5, noise = .5, graph = 6., prefilter = 1., planes = 1.,
                 thin_parts = 2., shrink = .5, step = 2.;

/// \param uses_normals whether the estimator does
/// \param prefiltered whether the flow is, and the estimator does not use normals
/// \param outputs how many of normals and feature strength are wanted
inline double total(unsigned int number_of_iterations, bool uses_normals, bool prefiltered,
                    int outputs)
{
  const double before = uses_normals ? planes : prefiltered ? prefilter + planes : 0.;
  return order + scale + graph + (uses_normals ? noise + thin_parts + shrink : 0.) +
         number_of_iterations * (before + step) + outputs * planes;
}
} // namespace work

/// A step that moves the points by less than this share of the noise is the last one, unless the
/// caller said how many there should be.
constexpr double negligible_movement = .01;

/// The flow on the private copy of the points (Table 1), from the reference to the result.
template <typename ConcurrencyTag, typename Flow, typename Curvature>
class Flow_run {
  static constexpr bool uses_normals = Uses_normals<Curvature>::value;
  // an estimator with normals filters by its weights
  static constexpr bool prefiltered = Uses_prefilter<Flow>::value && !uses_normals;

  Point_buffer& m_buffer;
  const Flow& m_flow;
  const Curvature& m_curvature;
  const Options& m_options;
  Progress& m_progress;
  double m_unit;
  Curvature_defaults m_defaults = Defaults_of<Curvature>::get();
  unsigned int m_number_of_iterations;
  double m_filter_width, m_step_length, m_sharpness_angle;
  double m_noise = 0.;
  Surface_state m_state;
  Neighbor_graph m_graph;

public:
  /// \param unit the length of 1 in the buffer, in the unit of the data
  Flow_run(Point_buffer& buffer, const Flow& flow, const Curvature& curvature,
           const Options& options, double unit, Progress& progress)
      : m_buffer(buffer), m_flow(flow), m_curvature(curvature), m_options(options),
        m_progress(progress), m_unit(unit),
        m_number_of_iterations(
            options.number_of_iterations.value_or(m_defaults.number_of_iterations)),
        m_filter_width(options.filter_width.value_or(m_defaults.filter_width)),
        m_step_length(options.step_length.value_or(m_defaults.step_length)),
        m_sharpness_angle(options.sharpness_angle.value_or(m_defaults.sharpness_angle)),
        m_graph(make_graph())
  {}

  /// All steps.
  /// \return the mean movement of the last one, in the unit of the buffer
  double operator()()
  {
    const std::size_t n = m_buffer.size();
    Diffusivity g(m_options.feature_threshold.value_or(0.));
    std::vector<Point_3> filtered(prefiltered ? n : 0), next(n);
    std::vector<Vector_3> normals(uses_normals ? n : 0);
    std::vector<double> variation(n);
    double moved = 0.;

    for (unsigned int t = 0; t < m_number_of_iterations; ++t) {
      if (m_options.update_period != 0 && t != 0 && t % m_options.update_period == 0)
        m_buffer.reference = m_buffer.points; // section 3.2
      m_state.time = m_number_of_iterations > 1 ? t / (m_number_of_iterations - 1.) : 0.;

      const bool choose_threshold = t == 0 && !m_options.feature_threshold;
      if (prefiltered)
        prefilter<ConcurrencyTag>(m_buffer.points, m_graph, m_filter_width, filtered, m_progress,
                                  work::prefilter);
      if (prefiltered || uses_normals || choose_threshold)
        find_tangent_planes<ConcurrencyTag>(
            prefiltered ? filtered : m_buffer.points, m_graph, m_filter_width, m_state, m_curvature,
            uses_normals ? &normals : nullptr, variation, m_progress, work::planes);
      if (uses_normals) {
        m_state.normals.resize(n);
        m_state.normals.swap(normals);
      }
      if (uses_normals && t == 0)
        adapt_neighborhoods();
      if (choose_threshold)
        g = automatic_diffusivity(variation);

      moved = flow_step<ConcurrencyTag>(m_buffer, m_graph, m_filter_width, m_state, m_curvature,
                                        prefiltered || uses_normals ? &variation : nullptr, m_flow,
                                        g, m_step_length, m_unit, next, m_progress, work::step);
      m_buffer.points.swap(next);
      if (!m_options.number_of_iterations && moved < negligible_movement * m_noise)
        break;
    }
    return moved;
  }

  /// The normals of the points where they are now; null vectors where there are less than two
  /// neighbours, and so no plane.
  std::vector<Vector_3> find_normals()
  {
    std::vector<Vector_3> normals(m_buffer.size());
    std::vector<double> variation(m_buffer.size());
    // Without the noise, nearer neighbours tell more, and the strict weights of the last step
    // would only hold on to the normals of the step before.
    const double width = uses_normals ? .5 * m_filter_width : m_filter_width;
    m_state.time = 0.;
    find_tangent_planes<ConcurrencyTag>(m_buffer.points, m_graph, width, m_state, m_curvature,
                                        &normals, variation, m_progress, work::planes);
    return normals;
  }

  /// \f$1 - g\f$ of the surface variation, Eq. (2), of the points where they are now
  std::vector<double> find_feature_strength()
  {
    std::vector<double> strength(m_buffer.size());
    find_tangent_planes<ConcurrencyTag>(m_buffer.points, m_graph, m_filter_width, m_state,
                                        Covariance_curvature(), nullptr, strength, m_progress,
                                        work::planes);
    const Diffusivity g = m_options.feature_threshold
                              ? Diffusivity(*m_options.feature_threshold)
                              : Diffusivity::half_at(crease_variation(m_sharpness_angle));
    for (double& x : strength)
      x = 1. - g(x);
    return strength;
  }

private:
  /// The neighbourhoods in the reference, which serve the whole run: the start may be anything.
  Neighbor_graph make_graph()
  {
    const ConcurrencyTag tag = ConcurrencyTag();
    const Neighbor_tree tree(tag, m_buffer.reference);
    const Sampled_scale scale = find_scale(tag, tree, m_progress, work::scale);
    m_noise = scale.noise;
    m_state.spacing = scale.spacing;
    double largest = m_noise;
    if (uses_normals) {
      m_state.noise = local_noise(tag, m_buffer.reference, scale, m_progress, work::noise);
      for (const double noise : m_state.noise)
        largest = (std::max)(largest, noise);
    }
    const double ratio = scale.spacing > 0. ? largest / scale.spacing : 0.;
    const unsigned int suited = neighborhood_size(m_defaults, ratio);
    const unsigned int k = m_options.k.value_or(suited);
    // of too few neighbours each one counts, near or not
    if (uses_normals && !m_options.filter_width && k < suited)
      m_filter_width *= double(suited) / k;
    return Neighbor_graph(tag, tree, k, m_options.neighbor_radius, m_progress, work::graph);
  }

  /// To thin parts and to noise that is not everywhere the same
  void adapt_neighborhoods()
  {
    const std::vector<std::uint32_t> sizes =
        find_thin_parts<ConcurrencyTag>(m_buffer.points, m_graph, m_filter_width, m_defaults,
                                        m_state, m_progress, work::thin_parts);
    if (!m_options.k)
      m_graph.template shrink<ConcurrencyTag>(m_buffer.reference, sizes, m_progress, work::shrink);
  }

  /// The diffusivity where the caller gave no K: 1/2 at a crease of the sharpness angle, but not
  /// below what the noise alone makes of a typical point.
  Diffusivity automatic_diffusivity(std::vector<double> variation) const
  {
    constexpr double above_noise = 2.;
    return Diffusivity::half_at(
        (std::max)(crease_variation(m_sharpness_angle), above_noise * median(variation)));
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_BALANCED_FLOW_INTERNAL_RUN_FLOW_H
