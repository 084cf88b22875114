// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FITTING_PLANE_WEIGHTS_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FITTING_PLANE_WEIGHTS_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/fitting/Neighbor_pairs.h>

#include <limits>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// The scales of the weights of `Tangent_plane_curvature` at one point at one time. All weights are
/// sums of exponents for `bell()`.
struct Plane_weights {
  // in multiples of the noise
  static constexpr double residual_width = 1.8, slab_width = 1.5;

  double distance, slab;
  double residual; ///< the distance from a tangent plane that is as likely noise as another sheet
  Angle_weight angle;

  explicit Plane_weights(const Neighborhood_3& neighborhood)
      : angle(neighborhood.spacing() > 0. ? neighborhood.noise() / neighborhood.spacing() : 0.,
              neighborhood.time())
  {
    const double width = neighborhood.gaussian_width(), noise = neighborhood.noise();
    distance = 1. / (2. * width * width + tiny());
    slab = slab_width * slab_width * noise * noise;
    residual = residual_width * noise * annealing(neighborhood.time(), 2);
  }

  /// The exponent of the distance, but not of the part of it that is noise
  Lanes near(const Lanes& squared_length, const Lanes& squared_height) const
  {
    return (squared_length - squared_height.min(slab)) * distance;
  }

  /// added to divisors that may be 0
  static constexpr double tiny() { return (std::numeric_limits<double>::min)(); }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FITTING_PLANE_WEIGHTS_H
