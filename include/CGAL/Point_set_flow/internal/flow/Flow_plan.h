// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FLOW_FLOW_PLAN_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FLOW_FLOW_PLAN_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/Diffusivity.h>
#include <CGAL/Point_set_flow/Smoothing_report.h>
#include <CGAL/Point_set_flow/internal/fitting/median.h>
#include <CGAL/Point_set_flow/internal/flow/Flow_parameters.h>
#include <CGAL/Point_set_flow/internal/flow/model_traits.h>
#include <CGAL/Point_set_flow/internal/flow/prefilter.h>
#include <CGAL/Point_set_flow/internal/flow/tangent_planes.h>
#include <CGAL/Point_set_flow/internal/neighbors/Block_cutter.h>
#include <CGAL/Point_set_flow/internal/noise/Analyzed_points.h>
#include <CGAL/Point_set_flow/internal/noise/Noise_levels.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// What is decided once, for the whole point set, from the parameters and from samples of the data.
class Flow_plan {
public:
  const Noise_map& noise_map;
  const Noise_levels noise;
  const bool uses_surface_estimate; ///< whether the estimator does
  /// whether the diffusivity is that of the prefiltered surface. An estimator that knows the noise
  /// needs no filter: its variation is what the noise does not explain.
  const bool is_prefiltered;
  const bool is_k_given;
  const Curvature_defaults defaults;
  const unsigned int number_of_iterations, update_period;
  const double step_length;
  const std::size_t number_of_points, number_of_distinct_points;
  const double unit; ///< the length of 1 in the core, in the unit of the data
  double filter_width;
  Search_options search;
  Diffusivity diffusivity = Diffusivity(0.);
  Diffusivity feature_diffusivity = diffusivity; ///< for the feature strength, whatever the noise

  template <typename Flow, typename Curvature, typename ConcurrencyTag>
  Flow_plan(const Analyzed_points& points, const Flow& flow, const Curvature& curvature,
            const Flow_parameters& parameters, double unit_, Loops<ConcurrencyTag>& loops)
      : noise_map(points.noise_map()), noise(points.buffer().noise, noise_map),
        uses_surface_estimate(Uses_surface_estimate<Curvature>::value),
        is_prefiltered(uses_prefilter(flow) && !uses_surface_estimate),
        is_k_given(parameters.k.has_value()), defaults(Defaults_of<Curvature>::get()),
        number_of_iterations(
            parameters.number_of_iterations.value_or(defaults.number_of_iterations)),
        update_period(parameters.update_period),
        step_length(parameters.step_length.value_or(defaults.step_length)),
        number_of_points(points.buffer().site_of.size()),
        number_of_distinct_points(points.buffer().size()), unit(unit_),
        filter_width(parameters.filter_width.value_or(defaults.filter_width))
  {
    plan_search(parameters);
    if (parameters.feature_threshold)
      diffusivity = feature_diffusivity = Diffusivity(*parameters.feature_threshold);
    else {
      const double above_noise = 2.; // features exceed the variation that noise causes anywhere
      const double noise_variation = above_noise * typical_variation(points, curvature, loops);
      const double crease =
          crease_variation(parameters.sharpness_angle.value_or(defaults.sharpness_angle));
      diffusivity = Diffusivity::half_at((std::max)(crease, noise_variation));
      feature_diffusivity = Diffusivity::half_at(crease);
    }
  }

  /// How many rings of neighbors around a point make the halo on which its result depends.
  std::size_t number_of_rings() const
  {
    const std::size_t steps = number_of_iterations, outputs = 1;
    return uses_surface_estimate ? 2 * steps + 3 + outputs
                                 : (is_prefiltered ? 2 : 1) * steps + outputs;
  }

  /// What is known before the flow runs
  Smoothing_report report() const
  {
    Smoothing_report report;
    report.number_of_points = number_of_points;
    report.number_of_distinct_points = number_of_distinct_points;
    report.noise = noise.typical * unit;
    report.spacing = noise_map.spacing() * unit;
    report.fewest_neighbors = report.most_neighbors = static_cast<unsigned int>(search.k);
    if (uses_surface_estimate && !is_k_given) {
      report.fewest_neighbors = suited_size(noise.least);
      report.most_neighbors = suited_size(noise.greatest);
    }
    const auto others = static_cast<unsigned int>(number_of_distinct_points - 1);
    report.fewest_neighbors = (std::min)(report.fewest_neighbors, others);
    report.most_neighbors = (std::min)(report.most_neighbors, others);
    report.number_of_iterations = number_of_iterations;
    report.filter_width = filter_width;
    report.feature_threshold = diffusivity.feature_threshold();
    return report;
  }

private:
  unsigned int suited_size(double level) const
  {
    const double spacing = noise_map.spacing();
    return defaults.neighborhood_size(spacing > 0. ? level / spacing : 0.);
  }

  void plan_search(const Flow_parameters& parameters)
  {
    const unsigned int suited = suited_size(
        uses_surface_estimate ? (std::max)(noise.typical, noise.greatest) : noise.typical);
    search.k = parameters.k.value_or(suited);
    if (parameters.neighbor_radius > 0.) // not 0 in the core, which would be no limit
      search.radius =
          (std::max)(parameters.neighbor_radius / unit, (std::numeric_limits<double>::min)());
    // too few neighbors for the noise are weighted more evenly
    if (uses_surface_estimate && !parameters.filter_width && search.k < suited)
      filter_width *= double(suited) / double(search.k);
  }

  /// The median variation of the surface in the first step, over a sample of points
  template <typename Curvature, typename ConcurrencyTag>
  double typical_variation(const Analyzed_points& points, const Curvature& curvature,
                           Loops<ConcurrencyTag>& loops) const
  {
    const std::size_t rings = is_prefiltered ? 2 : 1;
    Block_cutter cut(points.buffer(), points.tree(), search);
    Block block = cut(noise_map.samples().sites(), rings, loops);
    Surface_state state;
    state.spacing = noise_map.spacing();
    if (uses_surface_estimate)
      state.noise = noise_at_points(block, noise_map, loops);
    if (is_prefiltered) {
      Array<Point_3> filtered;
      prefilter(block.current_points(), block.graph, filter_width, filtered, loops);
      block.points.swap(filtered);
    }
    Array<double> variation(block.reference.size());
    find_tangent_planes({block.current_points(), block.graph, filter_width, state}, curvature,
                        nullptr, variation, loops);
    std::vector<double> of_samples;
    for (std::size_t i = 0; i < block.interior_size(); ++i)
      of_samples.push_back(variation[block.interior_place(i)]);
    return of_samples.empty() ? 0. : median(of_samples);
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FLOW_FLOW_PLAN_H
