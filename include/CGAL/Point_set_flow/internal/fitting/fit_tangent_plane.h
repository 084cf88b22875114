// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FITTING_FIT_TANGENT_PLANE_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FITTING_FIT_TANGENT_PLANE_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/Tangent_plane_3.h>
#include <CGAL/Point_set_flow/internal/fitting/Covariance_3.h>
#include <CGAL/Point_set_flow/internal/fitting/Plane_weights.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// Sums over neighbors, in lanes, of weights, weighted differences and their products
struct Weighted_moments {
  Lanes sum = Lanes::Zero(), x = sum, y = sum, z = sum;
  Lanes xx = sum, xy = sum, xz = sum, yy = sum, yz = sum, zz = sum;

  // inlined, or the loop would keep the sums in memory instead of registers
  BOOST_FORCEINLINE void add(const Lanes& weight, const Lanes_3& d)
  {
    const Lanes wx = weight * d.x, wy = weight * d.y, wz = weight * d.z;
    sum += weight, x += wx, y += wy, z += wz;
    xx += wx * d.x, xy += wx * d.y, xz += wx * d.z;
    yy += wy * d.y, yz += wy * d.z, zz += wz * d.z;
  }

  /// Eq. (1), about the centroid
  /// \param missing the weight that is not among those added
  /// \param total returns the sum of all weights
  Covariance_3 covariance(double missing, double& total) const
  {
    const Lanes none = Lanes::Zero();
    const Eigen::Array4d first = sums(sum, x, y, z).cast<double>(),
                         second = sums(xx, xy, xz, yy).cast<double>(),
                         third = sums(yz, zz, none, none).cast<double>();
    Covariance_3 c;
    c.xx = second[0], c.xy = second[1], c.xz = second[2], c.yy = second[3];
    c.yz = third[0], c.zz = third[1];
    total = first[0] + missing;
    c.add(Vector_3(first[1], first[2], first[3]) / total, -total);
    return c;
  }
};

/// The plane of Eq. (1), with weights by distance and, if the normals are known, by angle and by
/// distance from the tangent plane of the point. The variation is what the noise does not explain of Eq. (2).
template <bool has_normals>
[[gnu::flatten]] Tangent_plane_3 fit_tangent_plane(const Neighborhood_3& neighborhood)
{
  if (has_normals && !(neighborhood.noise() > 0.))
    return {neighborhood.normal(), 0.}; // nothing moves here, and the first plane will do
  const Plane_weights weigh(neighborhood);
  const float residual = Plane_weights::inverse(8. * weigh.residual * weigh.residual);
  const Neighbor_lanes lanes(neighborhood);

  // moments about the point, which the noise keeps near the centroid
  Weighted_moments moments;
  for (std::size_t j = 0; j < neighborhood.size(); j += Neighbor_lanes::width) {
    const Lane_numbers numbers = lanes.numbers(j);
    const Lanes_3 d = lanes.differences(numbers);
    Lanes exponent;
    if constexpr (has_normals) {
      const Lanes height = d * lanes.normal, squared = height * height;
      exponent = weigh.near(d.squared_length(), squared) + squared * residual +
                 weigh.angle.exponent(lanes.normals(numbers) * lanes.normal);
    }
    else
      exponent = d.squared_length() * weigh.distance;
    moments.add(bell(exponent), d);
  }
  double total;
  Covariance_3 c = moments.covariance(1. - lanes.pads(), total); // 1 for the point itself
  if constexpr (has_normals) {
    // The plane of the step before counts, too, though little: where hardly any neighbors are
    // left, their tiny weights would make the result depend on rounding.
    const double weight_before = .05, before = weight_before / (2. * double(weigh.distance));
    const Vector_3 n = neighborhood.normal();
    c.xx += before * (1. - n.x() * n.x()), c.xy -= before * n.x() * n.y();
    c.yy += before * (1. - n.y() * n.y()), c.xz -= before * n.x() * n.z();
    c.zz += before * (1. - n.z() * n.z()), c.yz -= before * n.y() * n.z();
  }
  const Smallest_eigenpair_3 pair = smallest_eigenpair(c);
  const double trace = c.trace();
  // twice the deviation of the noise is still noise: features must stand out
  const double explained = trace > 0. ? 4. * weigh.noise * weigh.noise * total / trace : 0.;
  return {pair.vector, (std::max)(0., pair.variation - explained)};
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FITTING_FIT_TANGENT_PLANE_H
