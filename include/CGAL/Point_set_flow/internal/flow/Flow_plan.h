// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FLOW_FLOW_PLAN_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FLOW_FLOW_PLAN_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/Diffusivity.h>
#include <CGAL/Point_set_flow/Smoothing_report.h>
#include <CGAL/Point_set_flow/internal/fitting/median.h>
#include <CGAL/Point_set_flow/internal/flow/Flow_parameters.h>
#include <CGAL/Point_set_flow/internal/flow/model_traits.h>
#include <CGAL/Point_set_flow/internal/neighbors/Surface.h>
#include <CGAL/Point_set_flow/internal/noise/Analyzed_points.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// What is decided before the flow runs, from the parameters and around each sample of the data.
class Flow_plan {
public:
  const bool uses_surface_estimate; ///< whether the estimator does
  /// whether the diffusivity is that of the prefiltered surface. An estimator that knows the noise
  /// needs no filter: its variation is what the noise does not explain.
  const bool is_prefiltered;
  const bool may_rest; ///< whether points without noise stay, and drop out of the steps
  const bool is_k_given, is_noise_given;
  const Curvature_defaults defaults;
  const unsigned int number_of_iterations, update_period, number_of_relaxation_steps;
  const unsigned int number_of_sheet_rounds; ///< of the estimator, before the first step
  const double step_length;
  const unsigned int number_of_corrections; ///< of the estimator, after the last step
  const std::size_t number_of_points, number_of_distinct_points;
  const double unit; ///< the length of 1 in the core, in the unit of the data
  const double filter_width;
  Diffusivity feature_diffusivity =
      Diffusivity(0.); ///< for the feature strength, whatever the noise
  std::vector<Local_parameters> parts;
  Search_options search;

  template <typename Flow, typename Curvature>
  Flow_plan(const Analyzed_points& points, const Flow& flow, const Curvature&,
            const Flow_parameters& parameters, double unit_)
      : uses_surface_estimate(Uses_surface_estimate<Curvature>::value),
        is_prefiltered(uses_prefilter(flow) && !uses_surface_estimate),
        may_rest(uses_surface_estimate && is_correctable(flow)),
        is_k_given(parameters.k.has_value()), is_noise_given(points.buffer().noise.is_given()),
        defaults(Defaults_of<Curvature>::get()),
        number_of_iterations(
            parameters.number_of_iterations.value_or(defaults.number_of_iterations)),
        update_period(parameters.update_period),
        number_of_relaxation_steps(parameters.number_of_relaxation_steps),
        number_of_sheet_rounds(Number_of_sheet_rounds<Curvature>::value),
        step_length(parameters.step_length.value_or(defaults.step_length)),
        number_of_corrections(number_of_iterations > 0 && step_length > 0. && is_correctable(flow)
                                  ? Number_of_corrections<Curvature>::value
                                  : 0),
        number_of_points(points.buffer().site_of.size()),
        number_of_distinct_points(points.buffer().size()), unit(unit_),
        filter_width(parameters.filter_width.value_or(defaults.filter_width))
  {
    const double crease =
        crease_variation(parameters.sharpness_angle.value_or(defaults.sharpness_angle));
    feature_diffusivity = parameters.feature_threshold ? Diffusivity(*parameters.feature_threshold)
                                                       : Diffusivity::half_at(crease);
    const double above_noise = 2.5; // features exceed the variation that noise causes anywhere
    parts.reserve(points.scale_map().scales().size());
    for (std::size_t i = 0; i < points.scale_map().scales().size(); ++i) {
      Local_parameters part = plan_size(points, i, parameters);
      part.diffusivity =
          parameters.feature_threshold
              ? feature_diffusivity
              : Diffusivity::half_at((std::max)(crease, above_noise * noise_variation(part)));
      parts.push_back(part);
    }
    plan_search(points, parameters);
  }

  Flow_plan(const Flow_plan&) = delete; // the state of the flow refers to the parts
  Flow_plan& operator=(const Flow_plan&) = delete;

  /// How many rings of neighbors around a point make the halo on which its result depends.
  std::size_t number_of_rings() const
  {
    const std::size_t steps = number_of_iterations, outputs = 1;
    const std::size_t relaxation =
        number_of_relaxation_steps == 0 ? 0 : 1 + std::size_t(number_of_relaxation_steps);
    return (uses_surface_estimate ? 2 * steps + 4 + number_of_sheet_rounds + number_of_corrections
                                  : (is_prefiltered ? 2 : 1) * steps) +
           relaxation + outputs;
  }

  /// What is known before the flow runs
  Smoothing_report report() const
  {
    Smoothing_report report;
    report.number_of_points = number_of_points;
    report.number_of_distinct_points = number_of_distinct_points;
    report.noise = median_of([](const Local_parameters& part) { return part.noise; }) * unit;
    report.spacing = median_of([](const Local_parameters& part) { return part.spacing; }) * unit;
    report.feature_threshold = median_of(
        [](const Local_parameters& part) { return part.diffusivity.feature_threshold(); });
    const auto sizes = std::minmax_element(
        parts.begin(), parts.end(),
        [](const Local_parameters& a, const Local_parameters& b) { return a.size < b.size; });
    const auto others = static_cast<unsigned int>(number_of_distinct_points - 1);
    report.fewest_neighbors = (std::min)(sizes.first->size, others);
    report.most_neighbors = (std::min)(sizes.second->size, others);
    report.number_of_iterations = number_of_iterations;
    report.number_of_relaxation_steps = number_of_relaxation_steps;
    report.filter_width = filter_width;
    return report;
  }

private:
  template <typename Value>
  double median_of(const Value& value) const
  {
    std::vector<double> values;
    for (const Local_parameters& part : parts)
      values.push_back(value(part));
    return median(values);
  }

  /// The noise around a sample, and the neighborhoods that suit it
  Local_parameters plan_size(const Analyzed_points& points, std::size_t i,
                             const Flow_parameters& parameters) const
  {
    const Scale_map& map = points.scale_map();
    const Local_scale& scale = map.scales()[i];
    Local_parameters part;
    part.noise = points.buffer().noise.of(map.sites()[i]).value_or(scale.noise);
    part.spacing = scale.spacing;
    part.least_size = scale.least_size;
    part.layers = scale.layers;
    part.size = defaults.neighborhood_size(part.spacing > 0. ? part.noise / part.spacing : 0.);
    // where points lie in lines or columns, a little more than what makes them a surface
    if (scale.least_size > Residuals::sizes.front())
      part.size = (std::max)(part.size, scale.least_size + scale.least_size / 4);
    part.filter_width = filter_width;
    if (parameters.k) {
      // too few neighbors for the noise are weighted more evenly
      if (uses_surface_estimate && !parameters.filter_width && *parameters.k < part.size)
        part.filter_width *= double(part.size) / double(*parameters.k);
      part.size = *parameters.k;
    }
    return part;
  }

  void plan_search(const Analyzed_points& points, const Flow_parameters& parameters)
  {
    if (parameters.k)
      search.k = *parameters.k;
    else {
      for (const Local_parameters& part : parts)
        search.k_of_parts.push_back(part.size);
      search.part_of = &points.part_of();
    }
    if (parameters.neighbor_radius > 0.) // not 0 in the core, which would be no limit
      search.radius =
          (std::max)(parameters.neighbor_radius / unit, (std::numeric_limits<double>::min)());
  }

  /// The variation, Eq. (2), that noise causes on a plane, whose points fill a disc.
  double noise_variation(const Local_parameters& part) const
  {
    if (uses_surface_estimate || !(part.spacing > 0.))
      return 0.;
    const double q = part.noise / part.spacing;
    double variance = q * q;
    if (is_prefiltered)
      variance *= left_by_prefilter(part);
    const double squared_radius = double(part.size) / CGAL_PI; // in spacings, as is the variance
    return variance / (squared_radius / 2. + variance);
  }

  /// The share of the variance of noise that the Gaussian leaves.
  static double left_by_prefilter(const Local_parameters& part)
  {
    const double squared_radius = double(part.size) / CGAL_PI;
    const double squared_width = part.filter_width * part.filter_width * squared_radius;
    if (!(squared_width > 0.))
      return 1.;
    const double x = squared_radius / squared_width;
    const double weights = 1. + 2. * CGAL_PI * squared_width * (1. - std::exp(-x / 2.));
    const double squares = 1. + CGAL_PI * squared_width * (1. - std::exp(-x));
    return squares / (weights * weights);
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FLOW_FLOW_PLAN_H
