// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_NOISE_SAMPLE_POINTS_H
#define CGAL_POINT_SET_FLOW_INTERNAL_NOISE_SAMPLE_POINTS_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/Core_kernel.h>
#include <CGAL/Point_set_flow/internal/parallel/Array.h>
#include <CGAL/Point_set_flow/internal/parallel/Loops.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// About 1,000 points spread evenly over the ranks of the distance to the centroid: the same ones
/// however the points are translated, rotated, scaled or numbered.
template <typename ConcurrencyTag>
std::vector<std::uint32_t> sample_points(const Array<Point_3>& points,
                                         const Loops<ConcurrencyTag>& loops)
{
  Vector_3 mean(0., 0., 0.);
  for (const Point_3& p : points)
    mean = mean + (p - ORIGIN);
  const Point_3 centroid = ORIGIN + mean / double(points.size());

  std::vector<std::pair<double, std::uint32_t>> ranked(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    ranked[i] = {squared_distance(points[i], centroid), static_cast<std::uint32_t>(i)};
  loops.sort(ranked.begin(), ranked.end());

  const std::size_t count = (std::min)(points.size(), std::size_t(1000));
  std::vector<std::uint32_t> chosen(count);
  for (std::size_t i = 0; i < count; ++i)
    chosen[i] = ranked[i * points.size() / count].second;
  loops.ask();
  return chosen;
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_NOISE_SAMPLE_POINTS_H
