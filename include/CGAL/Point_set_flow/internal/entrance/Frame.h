// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_ENTRANCE_FRAME_H
#define CGAL_POINT_SET_FLOW_INTERNAL_ENTRANCE_FRAME_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/Coordinate_frame.h>
#include <CGAL/Point_set_flow/Core_kernel.h>
#include <CGAL/Point_set_flow/internal/parallel/Array.h>
#include <CGAL/Point_set_flow/internal/parallel/Loops.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// How the coordinates of the core follow from those of the caller
struct Frame : Coordinate_frame {
  Frame() = default;
  Frame(const Coordinate_frame& frame) : Coordinate_frame(frame) {}

  template <typename Kernel_point_3>
  Point_3 to_core(const Kernel_point_3& p) const
  {
    return Point_3(to_core(to_double(p.x()), center[0]), to_core(to_double(p.y()), center[1]),
                   to_core(to_double(p.z()), center[2]));
  }

private:
  double to_core(double c, double from) const
  {
    // the difference of the largest numbers is out of the range of `double`
    return rounded(unit > 1. ? c / unit - from / unit : (c - from) / unit);
  }

  /// A whole multiple of \f$2^{-501}\f$: squared distances of distinct places must not become 0, or
  /// any number of places would be the nearest. Nothing else is as small: the extent of the points
  /// is at least \f$10^{-100}\f$.
  static double rounded(double c)
  {
    const double digits = 1.5 * std::ldexp(1., -449);
    return std::abs(c) < .25 * digits ? (c + digits) - digits : c;
  }
};

/// The frame of points, which are not empty. Its center is the median of each coordinate: a few
/// distant points, by which scanners mark missing data, do not cost the others their digits.
template <typename ConcurrencyTag>
Frame find_frame(const Array<Point_3>& points, Loops<ConcurrencyTag>& loops)
{
  double median[3], low[3], high[3];
  const auto find = [&](std::size_t d, std::size_t) {
    Array<double> coordinates(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
      coordinates[i] = points[i][int(d)];
    const auto middle = coordinates.begin() + std::ptrdiff_t(points.size() / 2);
    std::nth_element(coordinates.begin(), middle, coordinates.end());
    median[d] = *middle;
    low[d] = *std::min_element(coordinates.begin(), coordinates.end());
    high[d] = *std::max_element(coordinates.begin(), coordinates.end());
  };
  loops.for_each_chunk(3, find, 1);
  const auto point = [](const double* p) { return Point_3(p[0], p[1], p[2]); };
  return Coordinate_frame(point(median), point(low), point(high));
}

/// Brings a copy into the coordinates of the core.
inline void move_to_core(Array<Point_3>& points, const Frame& frame)
{
  for (Point_3& p : points)
    p = frame.to_core(p);
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_ENTRANCE_FRAME_H
