// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BALANCED_FLOW_TANGENT_PLANE_CURVATURE_H
#define CGAL_BALANCED_FLOW_TANGENT_PLANE_CURVATURE_H

#include <CGAL/Balanced_flow/Curvature_3.h>
#include <CGAL/Balanced_flow/Neighborhood_3.h>
#include <CGAL/Balanced_flow/internal/Angle_weight.h>
#include <CGAL/Balanced_flow/internal/Covariance_3.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Point_set_flow {

/// \ingroup PkgBalancedFlowRef
/// The directional curvature as the distance of a point from the tangent planes of its
/// neighbourhood, with weights that respect features. The default.
///
/// The distance of \f$p_i\f$ from a neighbour \f$p_j\f$ is taken along both normals,
/// \f$d_j = \frac12 [(p_i - p_j) \cdot n_i \pm (p_i - p_j) \cdot n_j]\f$. On a sphere the two terms
/// differ in sign only, so that the mean does not shrink a curved surface, as Eq. (3) does. The
/// directional curvature \f$\bar\kappa_i\f$ is the mean of the \f$d_j\f$, weighted by
/// - the distance of the neighbour,
/// - the angle between the two normals, and
/// - \f$d_j\f$ itself, against the noise: what lies farther off belongs to another sheet.
///
/// The last two become stricter from the first step to the last: first the noise must not be taken
/// for features, in the end features must not be taken for noise. The normals come from the
/// covariance, Eq. (1), with the same kind of weights.
///
/// It needs normals and the noise in the neighborhood. Without normals, in the first step, the
/// weights are Gaussians of the distance alone.
///
/// \cgalModels `PointSetCurvature`
class Tangent_plane_curvature {
public:
  typedef Tag_true Uses_normals;

  static Curvature_defaults defaults()
  {
    Curvature_defaults d;
    d.number_of_iterations = 6;
    d.filter_width = .6;
    d.step_length = .65;
    d.sharpness_angle = 60.;
    d.size_factor = 60., d.size_exponent = .7;
    d.smallest_size = 24, d.largest_size = 128;
    return d;
  }

  /// Eq. (1) with weights. The variation, Eq. (2), is what the noise does not explain.
  Tangent_plane_3 tangent_plane(const Neighborhood_3& neighborhood) const
  {
    const Weights weigh(neighborhood);
    const double residual = 1. / (8. * weigh.residual * weigh.residual + tiny());
    const bool first = !neighborhood.has_normals();
    const Vector_3 normal = first ? Vector_3(0., 0., 0.) : neighborhood.normal();

    internal::Covariance_3 moments; // about the point, which the noise keeps near the centroid
    Vector_3 mean(0., 0., 0.);
    double sum = 1.; // of the point itself
    for (std::size_t j = 0; j < neighborhood.size(); ++j) {
      const Vector_3 d = neighborhood[j] - neighborhood.center();
      double exponent = d.squared_length() * weigh.distance;
      if (!first) {
        const double z = d * normal;
        exponent += z * z * residual + weigh.angle.exponent(normal * neighborhood.normal(j));
      }
      const double weight = std::exp(-exponent);
      moments.add(d, weight);
      mean = mean + weight * d;
      sum += weight;
    }
    // neighbours that together weigh less than one tell no plane, and their tiny weights would
    // make the result depend on rounding
    if (!(sum > 1. + fewest) && !first)
      return {normal, 0.};

    mean = mean / sum;
    moments.add(mean, -sum);
    const internal::Smallest_eigenpair_3 pair = internal::smallest_eigenpair(moments);
    const double trace = moments.trace(), noise = weigh.residual / residual_width;
    // twice the deviation of the noise is still noise: features must stand out
    const double explained = trace > 0. ? 4. * noise * noise * sum / trace : 0.;
    return {pair.vector, (std::max)(0., pair.variation - explained)};
  }

  /// \pre `neighborhood.has_normals()`
  Curvature_3 operator()(const Neighborhood_3& neighborhood) const
  {
    const Weights weigh(neighborhood);
    const double residual = 1. / (2. * weigh.residual * weigh.residual + tiny());
    const Vector_3& normal = neighborhood.normal();

    double sum = 0., distances = 0., sum_of_all = 0., distances_of_all = 0.;
    for (std::size_t j = 0; j < neighborhood.size(); ++j) {
      const Vector_3 d = neighborhood.center() - neighborhood[j];
      const double cosine = normal * neighborhood.normal(j);
      const double z = d * normal, other = d * neighborhood.normal(j);
      const double distance = .5 * (z + (cosine < 0. ? -other : other));
      const double near = d.squared_length() * weigh.distance;
      const double weight = std::exp(-near - weigh.angle.exponent(cosine));
      const double trusted = weight * std::exp(-distance * distance * residual);
      sum += trusted;
      distances += trusted * distance;
      sum_of_all += weight;
      distances_of_all += weight * distance;
    }
    // a point too far off for all its neighbours still comes nearer, but not at once
    sum += few * sum_of_all;
    distances += few * distances_of_all;
    const double mean = distances / (sum + few); // and without any neighbours it stays
    return {normal, 0., (std::min)((std::max)(mean, -weigh.residual), weigh.residual)};
  }

private:
  // in multiples of the noise
  static constexpr double residual_width = 1.8;
  // weights of neighbours, each of which weighs 1 at most
  static constexpr double fewest = .5, few = .001;
  // the residual width of the last step in multiples of that of the first
  static constexpr double last_residual = .237;

  static constexpr double tiny() { return (std::numeric_limits<double>::min)(); }

  /// The scales of the weights at one point at one time
  struct Weights {
    double distance, residual;
    internal::Angle_weight angle;

    explicit Weights(const Neighborhood_3& neighborhood)
        : angle(neighborhood.spacing() > 0. ? neighborhood.noise() / neighborhood.spacing() : 0.,
                neighborhood.time())
    {
      const double width = neighborhood.gaussian_width(), noise = neighborhood.noise();
      distance = 1. / (2. * width * width + tiny());
      residual = residual_width * noise * std::pow(last_residual, neighborhood.time());
    }
  };
};

} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_BALANCED_FLOW_TANGENT_PLANE_CURVATURE_H
