// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FITTING_PLANE_DISTANCES_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FITTING_PLANE_DISTANCES_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/fitting/Plane_weights.h>
#include <CGAL/Point_set_flow/internal/fitting/Same_side.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// The distances of a point \f$p_i\f$ from two of its neighbors \f$p_j\f$, taken along both normals:
/// \f$d_j = \frac12 [(p_i - p_j) \cdot n_i \pm (p_i - p_j) \cdot n_j]\f$ with the sign of
/// \f$n_i \cdot n_j\f$. On a sphere the two terms differ in sign only.
struct Plane_distances {
  Lanes distance;       ///< \f$d_j\f$
  Lanes cosine;         ///< \f$n_i \cdot n_j\f$
  Lanes squared_length; ///< of \f$p_i - p_j\f$
  Lanes squared_height; ///< the part of it along \f$n_i\f$

  // inlined, or the loops would pass registers through memory
  BOOST_FORCEINLINE Plane_distances(const Neighbor_pairs& pairs, std::size_t j)
  {
    const Lanes_3 d = pairs.differences(j), normals = pairs.normals(j); // d is from i to j
    const Lanes own = d * pairs.normal, other = d * normals;
    cosine = normals * pairs.normal;
    const Lanes side(std::copysign(.5, cosine[0]), std::copysign(.5, cosine[1]));
    distance = -(.5 * own + side * other);
    squared_length = d.squared_length();
    squared_height = own * own;
  }
};

/// The weighted mean of the \f$d_j\f$, no longer than the noise allows.
/// \pre the normals of the neighborhood are known
inline double mean_plane_distance(const Neighborhood_3& neighborhood)
{
  if (neighborhood.size() < 2)
    return 0.;
  const Plane_weights weigh(neighborhood);
  // the exponent of what is too far off to count, and a small weight against division by 0; each
  // neighbor weighs 1 at most
  const double farthest = 7., few = .001;
  const double residual = 1. / (2. * weigh.residual * weigh.residual + Plane_weights::tiny());
  const Neighbor_pairs pairs(neighborhood);

  Lanes sum(0., 0.), distances = sum;
  for (std::size_t j = 0; j < neighborhood.size(); j += 2) {
    const Plane_distances d(pairs, j);
    // a point too far off for all its neighbors still comes nearer, but not at once
    const Lanes far = (d.distance * d.distance * residual).min(farthest);
    const Lanes weight =
        bell(weigh.near(d.squared_length, d.squared_height) + weigh.angle.exponent(d.cosine) + far);
    sum += weight;
    distances += weight * d.distance;
  }
  const double mean = distances.sum() / (sum.sum() - pairs.pads() + few);
  return (std::min)((std::max)(mean, -weigh.residual), weigh.residual);
}

/// Moments of the \f$d_j\f$ about their mean, weighted by angle and tangential distance
struct Distance_moments {
  double second, fourth;

  // cppcheck-suppress uninitMemberVar // those in an `Array` are not initialized on purpose
  Distance_moments() = default;

  Distance_moments(double second_, double fourth_) : second(second_), fourth(fourth_) {}

  /// The excess kurtosis; 0 where there is none, or where distances are out of the range of fourth powers
  double excess() const
  {
    const double e = second > 0. ? fourth / (second * second) - 3. : 0.;
    return std::isfinite(e) ? e : 0.;
  }

  /// The moments are in spacings, to keep fourth powers in the range of `double`.
  /// \param mean of the \f$d_j\f$, in spacings: the height of the point above its neighbors
  /// \pre the normals of the neighborhood are known, and the spacing is positive
  Distance_moments(const Neighborhood_3& neighborhood, double& mean) : second(0.), fourth(0.)
  {
    mean = 0.;
    if (neighborhood.size() < 2)
      return; // no plane
    if (neighborhood.is_sided()) {
      *this = Distance_moments(Same_side(neighborhood).neighborhood(), mean);
      return;
    }

    const Angle_weight angle(neighborhood.noise() / neighborhood.spacing(), 0.);
    const double width = neighborhood.gaussian_width();
    const double near = 1. / (2. * width * width + Plane_weights::tiny());
    const Neighbor_pairs pairs(neighborhood);
    Lanes in_pairs[5] = {Lanes(0., 0.), Lanes(0., 0.), Lanes(0., 0.), Lanes(0., 0.), Lanes(0., 0.)};
    for (std::size_t j = 0; j < neighborhood.size(); j += 2) {
      const Plane_distances d(pairs, j);
      const Lanes x = -d.distance / neighborhood.spacing();
      const Lanes tangential = (d.squared_length - d.squared_height).max(0.);
      Lanes power = bell(tangential * near + angle.exponent(d.cosine));
      for (Lanes& sum : in_pairs) {
        sum += power;
        power *= x;
      }
    }
    double sums[5];
    for (int i = 0; i < 5; ++i)
      sums[i] = in_pairs[i].sum();
    sums[0] -= pairs.pads();
    if (!(sums[0] > 0.))
      return; // no neighbors
    const double m1 = sums[1] / sums[0], m2 = sums[2] / sums[0], m3 = sums[3] / sums[0];
    mean = -m1;
    second = (std::max)(m2 - m1 * m1, 0.);
    fourth = (std::max)(
        sums[4] / sums[0] - 4. * m1 * m3 + 6. * m1 * m1 * m2 - 3. * m1 * m1 * m1 * m1, 0.);
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FITTING_PLANE_DISTANCES_H
