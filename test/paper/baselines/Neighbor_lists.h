// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_PAPER_BASELINES_NEIGHBOR_LISTS_H
#define POINT_SET_FLOW_PAPER_BASELINES_NEIGHBOR_LISTS_H

#include "measure/Nearest_points.h"

#include <cmath>
#include <vector>

namespace comparison {

/// The k nearest neighbors of all points, found once, without the points themselves.
class Neighbor_lists {
  std::vector<std::vector<std::size_t>> m_neighbors;
  std::vector<double> m_radii;

public:
  Neighbor_lists(const Points& points, unsigned int k)
  {
    const Nearest_points nearest(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      m_neighbors.emplace_back();
      m_radii.push_back(0.);
      for (const auto& found : nearest(points[i], k + 1))
        if (found.first != i) {
          m_neighbors.back().push_back(found.first);
          m_radii.back() = std::sqrt(found.second);
        }
    }
  }

  const std::vector<std::size_t>& operator[](std::size_t i) const { return m_neighbors[i]; }
  /// The distance of the farthest neighbor
  double radius(std::size_t i) const { return m_radii[i]; }
};

/// The Gaussian \f$e^{-x^2 / 2\sigma^2}\f$ of a squared distance
inline double gaussian(double squared, double sigma)
{
  return std::exp(-squared / (2. * sigma * sigma));
}

} // namespace comparison

#endif // POINT_SET_FLOW_PAPER_BASELINES_NEIGHBOR_LISTS_H
