// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_TANGENT_PLANE_CURVATURE_H
#define CGAL_POINT_SET_FLOW_TANGENT_PLANE_CURVATURE_H

#include <CGAL/Point_set_flow/Curvature_defaults.h>
#include <CGAL/Point_set_flow/Neighborhood_3.h>
#include <CGAL/Point_set_flow/internal/fitting/Angle_weight.h>
#include <CGAL/Point_set_flow/internal/fitting/Covariance_3.h>
#include <CGAL/Point_set_flow/internal/fitting/Neighbor_pairs.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Point_set_flow {

/// \ingroup PkgPointSetFlowCurvature
/// The directional curvature as the distance of a point from the tangent planes of its
/// neighborhood, with weights that respect features. The default.
///
/// The distance of \f$p_i\f$ from a neighbor \f$p_j\f$ is taken along both normals,
/// \f$d_j = \frac12 [(p_i - p_j) \cdot n_i \pm (p_i - p_j) \cdot n_j]\f$. On a sphere the two terms
/// differ in sign only, so that the mean does not shrink a curved surface, as equation (3) does. The
/// directional curvature \f$\bar\kappa_i\f$ is the mean of the \f$d_j\f$, weighted by
/// - the distance of the neighbor,
/// - the angle between the two normals, and
/// - \f$d_j\f$ itself, against the noise: what lies farther off belongs to another sheet.
///
/// The last two become stricter from the first step to the last: first the noise must not be taken
/// for features, in the end features must not be taken for noise. The normals come from the
/// covariance, equation (1), with the same kind of weights.
///
/// It needs normals and the noise in the neighborhood. Without normals, in the first step, the
/// weights are Gaussians of the distance alone.
///
/// \cgalModels{PointSetCurvature}
class Tangent_plane_curvature {
public:
  /// looks at the normals of the step before, and at the noise
  typedef Tag_true Uses_normals;

  /// what suits it: 5 steps, and 60 (noise / spacing)^0.7 neighbors, from 24 to 128
  static Curvature_defaults defaults()
  {
    Curvature_defaults d;
    d.number_of_iterations = 5;
    d.filter_width = .6;
    d.step_length = .75;
    d.sharpness_angle = 60.;
    d.size_factor = 60., d.size_exponent = .7;
    d.smallest_size = 24, d.largest_size = 128;
    return d;
  }

  /// Equation (1) with weights. The variation, equation (2), is what the noise does not explain.
  Tangent_plane_3 tangent_plane(const Neighborhood_3& neighborhood) const
  {
    return neighborhood.has_normals() ? tangent_plane<true>(neighborhood)
                                      : tangent_plane<false>(neighborhood);
  }

  /// The weighted mean of the \f$d_j\f$, no longer than the noise allows.
  /// \pre `neighborhood.has_normals()`
  Curvature_3 operator()(const Neighborhood_3& neighborhood) const
  {
    if (neighborhood.size() < 2)
      return {neighborhood.normal(), 0., 0.};
    const Weights weigh(neighborhood);
    const double residual = 1. / (2. * weigh.residual * weigh.residual + tiny());
    const internal::Two_by_two two(neighborhood);

    Lanes sum(0., 0.), distances = sum;
    for (std::size_t j = 0; j < neighborhood.size(); j += 2) {
      const Lanes_3 d = two.differences(j), normals = two.normals(j);
      const Lanes z = d * two.normal, cosine = normals * two.normal;
      const Lanes distance = -two.mean_height(z, d * normals, cosine);
      // a point too far off for all its neighbors still comes nearer, but not at once
      const Lanes far = (distance * distance * residual).min(farthest);
      const Lanes weight = internal::bell(weigh.near(d.squared_length(), z * z) +
                                          weigh.angle.exponent(cosine) + far);
      sum += weight;
      distances += weight * distance;
    }
    const double mean = distances.sum() / (sum.sum() - two.pads() + few);
    return {two.normal, 0., (std::min)((std::max)(mean, -weigh.residual), weigh.residual)};
  }

private:
  typedef internal::Lanes Lanes;
  typedef internal::Lanes_3 Lanes_3;

  // in multiples of the noise
  static constexpr double residual_width = 1.8, slab_width = 1.5;
  // weights of neighbors, each of which weighs 1 at most
  static constexpr double weight_before = .05, few = .001;
  // the exponent of what is too far off to count
  static constexpr double farthest = 7.;

  static constexpr double tiny() { return (std::numeric_limits<double>::min)(); }

  /// The scales of the weights at one point at one time
  struct Weights {
    double distance, residual, slab;
    internal::Angle_weight angle;

    explicit Weights(const Neighborhood_3& neighborhood)
        : angle(neighborhood.spacing() > 0. ? neighborhood.noise() / neighborhood.spacing() : 0.,
                neighborhood.time())
    {
      const double width = neighborhood.gaussian_width(), noise = neighborhood.noise();
      distance = 1. / (2. * width * width + tiny());
      residual = residual_width * noise * internal::annealing(neighborhood.time(), 2);
      slab = slab_width * slab_width * noise * noise;
    }

    /// The exponent of the distance, but not of the part of it that is noise
    Lanes near(const Lanes& squared_length, const Lanes& squared_height) const
    {
      return (squared_length - squared_height.min(slab)) * distance;
    }
  };

  template <bool has_normals>
  static Tangent_plane_3 tangent_plane(const Neighborhood_3& neighborhood)
  {
    if (has_normals && !(neighborhood.noise() > 0.))
      return {neighborhood.normal(), 0.}; // nothing moves here, and the first plane will do
    const Weights weigh(neighborhood);
    const double residual = 1. / (8. * weigh.residual * weigh.residual + tiny());
    const internal::Two_by_two two(neighborhood);

    // moments about the point, which the noise keeps near the centroid
    const Lanes zero(0., 0.);
    Lanes sum = zero, x = zero, y = zero, z = zero;
    Lanes xx = zero, xy = zero, xz = zero, yy = zero, yz = zero, zz = zero;
    for (std::size_t j = 0; j < neighborhood.size(); j += 2) {
      const Lanes_3 d = two.differences(j);
      Lanes exponent;
      if constexpr (has_normals) {
        const Lanes height = d * two.normal, squared = height * height;
        exponent = weigh.near(d.squared_length(), squared) + squared * residual +
                   weigh.angle.exponent(two.normals(j) * two.normal);
      }
      else
        exponent = d.squared_length() * weigh.distance;
      const Lanes weight = internal::bell(exponent);
      const Lanes wx = weight * d.x, wy = weight * d.y, wz = weight * d.z;
      sum += weight, x += wx, y += wy, z += wz;
      xx += wx * d.x, xy += wx * d.y, xz += wx * d.z;
      yy += wy * d.y, yz += wy * d.z, zz += wz * d.z;
    }
    const double total = sum.sum() + 1. - two.pads(); // the point itself
    internal::Covariance_3 moments;
    moments.xx = xx.sum(), moments.xy = xy.sum(), moments.xz = xz.sum();
    moments.yy = yy.sum(), moments.yz = yz.sum(), moments.zz = zz.sum();
    moments.add(Vector_3(x.sum(), y.sum(), z.sum()) / total, -total);
    if constexpr (has_normals) {
      // The plane of the step before counts, too, though little: where hardly any neighbors are
      // left, their tiny weights would make the result depend on rounding.
      const double before = weight_before / (2. * weigh.distance);
      const Vector_3& n = two.normal;
      moments.xx += before * (1. - n.x() * n.x()), moments.xy -= before * n.x() * n.y();
      moments.yy += before * (1. - n.y() * n.y()), moments.xz -= before * n.x() * n.z();
      moments.zz += before * (1. - n.z() * n.z()), moments.yz -= before * n.y() * n.z();
    }
    const internal::Smallest_eigenpair_3 pair = internal::smallest_eigenpair(moments);
    const double trace = moments.trace(), noise = weigh.residual / residual_width;
    // twice the deviation of the noise is still noise: features must stand out
    const double explained = trace > 0. ? 4. * noise * noise * total / trace : 0.;
    return {pair.vector, (std::max)(0., pair.variation - explained)};
  }
};

} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_TANGENT_PLANE_CURVATURE_H
