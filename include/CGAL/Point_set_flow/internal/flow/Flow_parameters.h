// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FLOW_FLOW_PARAMETERS_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FLOW_FLOW_PARAMETERS_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/Curvature_defaults.h>

#include <cstddef>
#include <optional>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// The parameters of a run as plain numbers. Documented at `balanced_flow_smooth_point_set()`.
/// Those not set are chosen from the data, or are defaults of the curvature estimator.
struct Flow_parameters {
  std::optional<unsigned int> k;
  double neighbor_radius = 0.; // 0: no limit
  std::optional<unsigned int> number_of_iterations;
  std::optional<double> sharpness_angle;
  std::optional<double> feature_threshold;
  std::optional<double> filter_width;
  std::optional<double> step_length;
  unsigned int update_period = 4; // 0: never
  unsigned int number_of_relaxation_steps = 0;
  std::size_t block_size = std::size_t(1) << 22;
};

/// How many neighbors of each point will suit the flow, before that is known: those for noise of .55 spacings if
/// they are not given. Searched once, they serve the analysis and the flow.
/// \return 0 if the neighbors are searched anew for the flow: block by block, or with a limit
inline std::size_t likely_size(const Flow_parameters& parameters,
                               const Curvature_defaults& defaults, std::size_t number_of_points)
{
  if (number_of_points > parameters.block_size || parameters.neighbor_radius > 0.)
    return 0;
  return parameters.k ? *parameters.k : defaults.neighborhood_size(.55);
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FLOW_FLOW_PARAMETERS_H
