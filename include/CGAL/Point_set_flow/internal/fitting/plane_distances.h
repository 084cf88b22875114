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

/// The distances of a point \f$p_i\f$ from some of its neighbors \f$p_j\f$, taken along both normals:
/// \f$d_j = \frac12 [(p_i - p_j) \cdot n_i \pm (p_i - p_j) \cdot n_j]\f$ with the sign of
/// \f$n_i \cdot n_j\f$. On a sphere the two terms differ in sign only. Lengths are in neighborhood radii.
struct Plane_distances {
  Lanes distance;       ///< \f$d_j\f$
  Lanes cosine;         ///< \f$n_i \cdot n_j\f$
  Lanes squared_length; ///< of \f$p_i - p_j\f$
  Lanes squared_height; ///< the part of it along \f$n_i\f$

  // inlined, or the loops would pass registers through memory
  BOOST_FORCEINLINE Plane_distances(const Neighbor_lanes& lanes, std::size_t j)
  {
    const Lane_numbers numbers = lanes.numbers(j);
    const Lanes_3 d = lanes.differences(numbers),
                  normals = lanes.normals(numbers); // d is from i to j
    const Lanes own = d * lanes.normal, other = d * normals;
    cosine = normals * lanes.normal;
    distance = -.5f * (own + flipped(other, cosine));
    squared_length = d.squared_length();
    squared_height = own * own;
  }
};

/// The weighted mean of the \f$d_j\f$, no longer than the noise allows.
/// \pre the normals of the neighborhood are known
[[gnu::flatten]] inline double mean_plane_distance(const Neighborhood_3& neighborhood)
{
  if (neighborhood.size() < 2 || !(neighborhood.noise() > 0.))
    return 0.;
  const Plane_weights weigh(neighborhood);
  // the exponent of what is too far off to count, and a small weight against division by 0; each
  // neighbor weighs 1 at most
  const float farthest = 7.f;
  const double few = .001;
  const float residual = Plane_weights::inverse(2. * weigh.residual * weigh.residual);
  const Neighbor_lanes lanes(neighborhood);
  Lanes weights = Lanes::Zero(), distances = weights;
  for (std::size_t j = 0; j < neighborhood.size(); j += Neighbor_lanes::width) {
    const Plane_distances d(lanes, j);
    // a point too far off for all its neighbors still comes nearer, but not at once
    const Lanes far = (d.distance * d.distance * residual).min(farthest);
    const Lanes weight =
        bell(weigh.near(d.squared_length, d.squared_height) + weigh.angle.exponent(d.cosine) + far);
    weights += weight;
    distances += weight * d.distance;
  }
  const Four both = sums(weights, distances, weights, distances);
  const double mean = double(both[1]) / (double(both[0]) - lanes.pads() + few);
  return (std::min)((std::max)(mean, -weigh.residual), weigh.residual) * neighborhood.radius();
}

/// Moments of the \f$d_j\f$ about their mean, weighted by angle and tangential distance
struct Distance_moments {
  double second, fourth;

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
  [[gnu::flatten]] Distance_moments(const Neighborhood_3& neighborhood, double& mean)
      : second(0.), fourth(0.)
  {
    mean = 0.;
    if (neighborhood.size() < 2)
      return; // no plane
    if (neighborhood.is_sided()) {
      *this = Distance_moments(Same_side(neighborhood).neighborhood(), mean);
      return;
    }

    const Angle_weight angle(neighborhood.noise() / neighborhood.spacing(), 0.);
    const double width = neighborhood.filter_width();
    const float near = Plane_weights::inverse(2. * width * width);
    const float in_spacings = float(-neighborhood.radius() / neighborhood.spacing());
    const Neighbor_lanes lanes(neighborhood);
    Lanes in_lanes[5] = {Lanes::Zero(), Lanes::Zero(), Lanes::Zero(), Lanes::Zero(), Lanes::Zero()};
    for (std::size_t j = 0; j < neighborhood.size(); j += Neighbor_lanes::width) {
      const Plane_distances d(lanes, j);
      const Lanes x = d.distance * in_spacings;
      const Lanes tangential = (d.squared_length - d.squared_height).max(0.f);
      Lanes power = bell(tangential * near + angle.exponent(d.cosine));
      for (Lanes& sum_of_powers : in_lanes) {
        sum_of_powers += power;
        power *= x;
      }
    }
    const Eigen::Array4d first =
        sums(in_lanes[0], in_lanes[1], in_lanes[2], in_lanes[3]).cast<double>();
    const double total = first[0] - lanes.pads();
    if (!(total > 0.))
      return; // no neighbors
    const double inverse = 1. / total, m1 = first[1] * inverse, m2 = first[2] * inverse,
                 m3 = first[3] * inverse, m4 = double(in_lanes[4].sum()) * inverse;
    mean = -m1;
    second = (std::max)(m2 - m1 * m1, 0.);
    fourth = (std::max)(m4 - 4. * m1 * m3 + 6. * m1 * m1 * m2 - 3. * m1 * m1 * m1 * m1, 0.);
  }
};

/// Moments in single precision, to save memory: the fourth one relative to the second one, since the range of `float`
/// is small
class Compact_moments {
  float m_second = 0.f, m_fourth_to_second = 0.f;

public:
  Compact_moments() = default;
  explicit Compact_moments(const Distance_moments& m)
      : m_second(float(m.second)),
        m_fourth_to_second(m.second > 0. ? float(m.fourth / m.second) : 0.f)
  {}
  Distance_moments moments() const
  {
    const double second = double(m_second);
    return {second, second * double(m_fourth_to_second)};
  }
  double deviation() const { return std::sqrt(double(m_second)); }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FITTING_PLANE_DISTANCES_H
