// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_PAPER_BASELINES_LAPLACIAN_H
#define POINT_SET_FLOW_PAPER_BASELINES_LAPLACIAN_H

#include "Neighbor_lists.h"

namespace comparison {

/// Laplacian smoothing of points: M. Pauly, L. Kobbelt, M. Gross, *Multiresolution modeling of
/// point-sampled geometry*, ETH technical report 378, 2002, section on smoothing, with the umbrella
/// of Desbrun et al. 1999 over the k nearest neighbors instead of those in a mesh:
///
///     p_i <- p_i + lambda Delta_i,    Delta_i = 1/k sum_j (p_j - p_i)
///
/// The step has a part within the surface, which evens the sampling out: points drift, away from
/// borders and from where they are dense. And it shrinks. The report compensates for that: each point
/// gives its step back to its neighbors, 1/k of it to each; `compensated` does that. The paper
/// compares with the method without it.
inline Points laplacian(Points points, unsigned int k, int iterations, double lambda = .5,
                        bool compensated = false)
{
  const Neighbor_lists neighbors(points, k);
  for (int t = 0; t < iterations; ++t) {
    Vectors steps(points.size(), CGAL::NULL_VECTOR);
    for (std::size_t i = 0; i < points.size(); ++i) {
      Vector_3 mean = CGAL::NULL_VECTOR;
      const double share = 1. / double(neighbors[i].size());
      for (const std::size_t j : neighbors[i])
        mean += share * (points[j] - points[i]);
      steps[i] += lambda * mean;
      if (compensated)
        for (const std::size_t j : neighbors[i])
          steps[j] -= share * lambda * mean;
    }
    for (std::size_t i = 0; i < points.size(); ++i)
      points[i] += steps[i];
  }
  return points;
}

} // namespace comparison

#endif // POINT_SET_FLOW_PAPER_BASELINES_LAPLACIAN_H
