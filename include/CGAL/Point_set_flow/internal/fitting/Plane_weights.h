// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FITTING_PLANE_WEIGHTS_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FITTING_PLANE_WEIGHTS_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/fitting/Neighbor_lanes.h>

#include <limits>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// The scales of the weights of `Tangent_plane_curvature` at one point at one time, with lengths in neighborhood
/// radii. All weights are sums of exponents for `bell()`.
struct Plane_weights {
  // in multiples of the noise
  static constexpr double residual_width = 1.8, slab_width = 1.5;

  float distance, slab;
  double noise;
  double residual; ///< the distance from a tangent plane that is as likely noise as another sheet
  Angle_weight angle;

  explicit Plane_weights(const Neighborhood_3& neighborhood)
      : angle(neighborhood.spacing() > 0. ? neighborhood.noise() / neighborhood.spacing() : 0.,
              neighborhood.time())
  {
    const double width = neighborhood.filter_width();
    distance = inverse(2. * width * width);
    noise = neighborhood.radius() > 0. ? neighborhood.noise() / neighborhood.radius() : 0.;
    slab = float(slab_width * slab_width * noise * noise);
    noise *= annealing(neighborhood.time(), 2);
    residual = residual_width * noise;
  }

  /// The exponent of the distance, but not of the part of it that is noise
  BOOST_FORCEINLINE Lanes near(const Lanes& squared_length, const Lanes& squared_height) const
  {
    return (squared_length - squared_height.min(slab)) * distance;
  }

  /// of a divisor that may be 0
  static float inverse(double x) { return 1.f / (float(x) + (std::numeric_limits<float>::min)()); }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FITTING_PLANE_WEIGHTS_H
