// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FITTING_CORRECTION_INPUT_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FITTING_CORRECTION_INPUT_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/fitting/Network_input.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// What the learned correction sees of a point after the flow: heights above the tangent planes, and the
/// residuals, all in the rms residual around the point.
struct Correction_input : Network_input<2, 3, 2, 1> {
  double unit; ///< the rms residual around the point, a length

  /// \pre `neighborhood.has_residuals()`; there are neighbors
  [[gnu::flatten]] explicit Correction_input(const Neighborhood_3& neighborhood)
      : Network_input(neighborhood)
  {
    const double radius = neighborhood.radius();
    const double inverse = 1. / radius;
    for (std::size_t i = 0; i < std::size_t(size); ++i)
      at(odd[2], i) = float(neighborhood.residual(spread(neighborhood, i)) * inverse);
    read_edges(neighborhood);
    const double own = neighborhood.residual() / radius;
    Lanes squares = Lanes::Zero();
    for (const Lanes& residuals : odd[2])
      squares += residuals * residuals;
    const double mean_square = double(squares.sum()) / double(size);
    const double least = .001; // of the radius: on a clean surface all residuals are 0
    const double relative = (std::max)(std::sqrt(.97 * mean_square + .03 * own * own), least);
    unit = relative * radius;
    for (Edge_lanes& lanes : odd)
      squash(lanes, static_cast<float>(relative));
    of_point_even = {static_cast<float>(std::log(relative)),
                     limited(std::log(unit / neighborhood.noise()), 3.)};
    of_point_odd = {squashed(static_cast<float>(own / relative))};
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FITTING_CORRECTION_INPUT_H
