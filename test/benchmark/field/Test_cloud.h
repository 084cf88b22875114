// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_BENCHMARK_TEST_CLOUD_H
#define POINT_SET_FLOW_BENCHMARK_TEST_CLOUD_H

#include "measure/Nearest_points.h"
#include "measure/Smoothers.h"
#include "measure/Smoothing_measures.h"

#include <CGAL/for_each.h>

#include <memory>
#include <random>
#include <string>

namespace comparison {

/// Points as a sensor would give them, and the surface that they were measured on.
struct Test_cloud {
  std::string name;
  std::shared_ptr<const Surface> surface;
  Points points;
  std::vector<char> belongs;       ///< whether a point was measured on the surface; all if empty
  Vectors normals;                 ///< that are given with the points; empty if there are none
  std::vector<unsigned int> scans; ///< the number of the scan of each point; empty if not given
  double spacing = 1.;             ///< to count lengths in; where the spacing varies, of one part

  /// Distances are unsigned as a rule; the square root of the mean square is the error.
  double error_of(const Points& smoothed) const
  {
    std::vector<double> squares(smoothed.size());
    CGAL::for_each<Concurrency_tag>(numbers(smoothed.size()), [&](const std::size_t& i) {
      const double d = counts(i) ? surface->closest(smoothed[i]).signed_distance : 0.;
      squares[i] = d * d;
      return true;
    });
    Error_sum sum;
    for (std::size_t i = 0; i < smoothed.size(); ++i)
      if (counts(i))
        sum.add(std::sqrt(squares[i]));
    return sum.rms();
  }
  bool counts(std::size_t i) const { return belongs.empty() || belongs[i]; }
};

/// The share of points that are not where they were
inline double share_moved(const Points& from, const Points& to)
{
  std::size_t moved = 0;
  for (std::size_t i = 0; i < from.size(); ++i)
    moved += from[i] != to[i];
  return double(moved) / double(from.size());
}

/// The distance that as many evenly distributed points would have: from the median distance of the
/// twelfth neighbors
inline double typical_spacing(const Points& points)
{
  const Nearest_points nearest(points);
  std::vector<double> squares(points.size());
  CGAL::for_each<Concurrency_tag>(numbers(points.size()), [&](const std::size_t& i) {
    squares[i] = nearest(points[i], 13).back().second;
    return true;
  });
  const auto middle = squares.begin() + std::ptrdiff_t(squares.size() / 2);
  std::nth_element(squares.begin(), middle, squares.end());
  return std::sqrt(CGAL_PI * *middle / 12.);
}

} // namespace comparison

#endif // POINT_SET_FLOW_BENCHMARK_TEST_CLOUD_H
