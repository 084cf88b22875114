// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_ENTRANCE_FRAME_H
#define CGAL_POINT_SET_FLOW_INTERNAL_ENTRANCE_FRAME_H

#include <CGAL/license/Point_set_flow.h>

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

/// How the coordinates of the core follow from those of the caller: \f$(p - center) / unit\f$.
///
/// Moving the data to the origin keeps the digits of georeferenced points. The unit is 1 for any
/// ordinary data and a power of 2 where squared distances would leave the range of `double`.
struct Frame {
  double center[3] = {0., 0., 0.};
  double unit = 1.;

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
  Frame frame;
  double extents[3];
  const auto find = [&](std::size_t d, std::size_t) {
    Array<double> coordinates(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
      coordinates[i] = points[i][int(d)];
    const auto middle = coordinates.begin() + std::ptrdiff_t(points.size() / 2);
    std::nth_element(coordinates.begin(), middle, coordinates.end());
    frame.center[d] = *middle;
    extents[d] = 0.;
    for (const double c : coordinates)
      extents[d] = (std::max)(extents[d], std::abs(c / 2. - frame.center[d] / 2.));
  };
  loops.for_each_chunk(3, find, 1);
  const double extent = (std::max)({extents[0], extents[1], extents[2]});
  if (extent > 1e140) // no smaller than squares require
    frame.unit = std::ldexp(1., std::ilogb(extent) - 465);
  else if (extent != 0. && extent < 1e-100)
    frame.unit = std::ldexp(1., (std::max)(std::ilogb(extent), -1020));
  return frame;
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
