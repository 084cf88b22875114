// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef COMPARISON_NEAREST_POINTS_H
#define COMPARISON_NEAREST_POINTS_H

#include "Surface.h"

#include <memory>
#include <utility>

namespace comparison {

/// The nearest points of a set, by their numbers.
class Nearest_points {
  struct Search;
  std::unique_ptr<const Search> m_search;

public:
  explicit Nearest_points(const Points& points);
  ~Nearest_points();

  /// Pairs of number and squared distance, the nearest first
  std::vector<std::pair<std::size_t, double>> operator()(const Point_3& p, unsigned int k) const;
  std::pair<std::size_t, double> operator()(const Point_3& p) const;
};

} // namespace comparison

#endif // COMPARISON_NEAREST_POINTS_H
