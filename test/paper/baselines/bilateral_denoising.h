// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_PAPER_BASELINES_BILATERAL_DENOISING_H
#define POINT_SET_FLOW_PAPER_BASELINES_BILATERAL_DENOISING_H

#include "Neighbor_lists.h"

#include "measure/Numbered_points.h"

#include <algorithm>

namespace comparison {

/// The rms height of the neighbors above the tangent planes: median over the points. What Fleishman
/// et al. take for sigma_s is this of a neighborhood that the user has pointed at, where the surface
/// is smooth; the median needs no user.
inline double typical_offset(const Points& points, const Vectors& normals,
                             const Neighbor_lists& neighbors)
{
  std::vector<double> offsets;
  for (std::size_t i = 0; i < points.size(); ++i) {
    double squares = 0., sum = 0.;
    for (const std::size_t j : neighbors[i]) {
      const double h = normals[i] * (points[j] - points[i]);
      sum += h;
      squares += h * h;
    }
    const double n = double(neighbors[i].size());
    offsets.push_back(std::sqrt((std::max)(0., squares / n - sum * sum / (n * n))));
  }
  const auto middle = offsets.begin() + std::ptrdiff_t(offsets.size() / 2);
  std::nth_element(offsets.begin(), middle, offsets.end());
  return *middle;
}

/// Bilateral mesh denoising: S. Fleishman, I. Drori, D. Cohen-Or, SIGGRAPH 2003, the algorithm of their
/// Fig. 2, for points, as the paper has it: the neighbors are the k nearest instead of those in a mesh,
/// and the normals are found by covariance analysis before each iteration.
///
///     p <- p + n (sum_j W_c(|p_j - p|) W_s(h_j) h_j) / (sum_j W_c W_s),    h_j = n (p_j - p)
///
/// with Gaussians W_c and W_s of widths sigma_c and sigma_s. Their neighborhood has the radius
/// 2 sigma_c; so sigma_c is half the radius of ours. sigma_s is the deviation of the heights, times
/// `influence`.
inline Points bilateral_denoising(Points points, unsigned int k, int iterations,
                                  double influence = 1.)
{
  const Neighbor_lists neighbors(points, k);
  double sigma_s = 0.;
  for (int t = 0; t < iterations; ++t) {
    const Vectors normals = normals_in_order(with_normals<CGAL::Sequential_tag>(points, false, k));
    if (t == 0)
      sigma_s = influence * typical_offset(points, normals, neighbors);
    Points moved = points;
    for (std::size_t i = 0; i < points.size(); ++i) {
      double sum = 0., weights = 0.;
      for (const std::size_t j : neighbors[i]) {
        const Vector_3 d = points[j] - points[i];
        const double h = normals[i] * d;
        const double weight =
            gaussian(d.squared_length(), neighbors.radius(i) / 2.) * gaussian(h * h, sigma_s);
        sum += weight * h;
        weights += weight;
      }
      if (weights > 0.)
        moved[i] += (sum / weights) * normals[i];
    }
    points.swap(moved);
  }
  return points;
}

} // namespace comparison

#endif // POINT_SET_FLOW_PAPER_BASELINES_BILATERAL_DENOISING_H
