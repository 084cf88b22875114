// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_PAPER_BASELINES_NON_ITERATIVE_H
#define POINT_SET_FLOW_PAPER_BASELINES_NON_ITERATIVE_H

#include "bilateral_denoising.h"

namespace comparison {

/// Non-iterative, feature-preserving smoothing: T. Jones, F. Durand, M. Desbrun, SIGGRAPH 2003, for
/// points and without area weights, as the paper has it. Each point stands for a triangle: it is the
/// centroid c_q, and its tangent plane is the one that predicts.
///
///     p <- (sum_q Pi_q(p) a_q f(|c_q - p|) g(|Pi_q(p) - p|)) / (sum_q a_q f g),    a_q = 1
///
/// where Pi_q(p) is the projection of p to the plane through c_q (their Eq. 3), f and g are
/// Gaussians. Two passes, as theirs: the normals of the planes are those of mollified points, which
/// the spatial Gaussian alone has smoothed, with half the width (their section on mollification).
/// sigma_f is half the radius of the neighborhood, and sigma_g the deviation of the heights, as in
/// `bilateral_denoising()`, so that both see the same.
///
/// The predictions do not lie along one normal. So points move within the surface, too, where the
/// planes differ: near edges and wherever normals are noisy.
inline Points non_iterative(const Points& points, unsigned int k, double influence = 1.)
{
  const Neighbor_lists neighbors(points, k);
  Points mollified = points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    Vector_3 sum = CGAL::NULL_VECTOR;
    double weights = 1.; // of the point itself
    for (const std::size_t j : neighbors[i]) {
      const Vector_3 d = points[j] - points[i];
      const double weight = gaussian(d.squared_length(), neighbors.radius(i) / 4.);
      sum += weight * d;
      weights += weight;
    }
    mollified[i] += sum / weights;
  }
  const Vectors normals = normals_in_order(with_normals<CGAL::Sequential_tag>(mollified, false, k));
  const double sigma_g =
      influence *
      typical_offset(points, normals_in_order(with_normals<CGAL::Sequential_tag>(points, false, k)),
                     neighbors);

  Points moved = points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    Vector_3 sum = CGAL::NULL_VECTOR; // the point predicts itself with weight 1
    double weights = 1.;
    for (const std::size_t j : neighbors[i]) {
      const Vector_3 d = points[j] - points[i];
      const double height = d * normals[j]; // to the plane of j
      const double weight = gaussian(d.squared_length(), neighbors.radius(i) / 2.) *
                            gaussian(height * height, sigma_g);
      sum += weight * height * normals[j];
      weights += weight;
    }
    moved[i] += sum / weights;
  }
  return moved;
}

} // namespace comparison

#endif // POINT_SET_FLOW_PAPER_BASELINES_NON_ITERATIVE_H
