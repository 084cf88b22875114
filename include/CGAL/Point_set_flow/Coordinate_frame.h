// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_COORDINATE_FRAME_H
#define CGAL_POINT_SET_FLOW_COORDINATE_FRAME_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/Core_kernel.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Point_set_flow {

/// \ingroup PkgPointSetFlowFunctions
/// The coordinates in which a point set is smoothed: \f$(p - center) / unit\f$.
///
/// Moving the data to the origin keeps the digits of georeferenced points. The unit is 1 for any ordinary
/// data and a power of 2 where squared distances would leave the range of `double`.
///
/// `balanced_flow_smooth_point_set()` finds the frame by itself. `smooth_block()` sees some points of a
/// point set only and is told that of all of them. `find_coordinate_frame()` finds it for points in memory.
struct Coordinate_frame {
  Point_3 center = Point_3(0., 0., 0.); ///< the median of each coordinate
  double unit = 1.;                     ///< a power of 2

  /// the coordinates of the caller
  Coordinate_frame() = default;

  /// the frame of n points, which are finite.
  /// \param median of each coordinate the element n / 2 in ascending order, counted from 0
  /// \param low, high the corners of their bounding box
  Coordinate_frame(const Point_3& median, const Point_3& low, const Point_3& high) : center(median)
  {
    double extent = 0.;
    for (int d = 0; d < 3; ++d) // halves: differences may be out of the range of `double`
      extent = (std::max)({extent, std::abs(low[d] / 2. - center[d] / 2.),
                           std::abs(high[d] / 2. - center[d] / 2.)});
    if (extent > 1e140) // no smaller than squares require
      unit = std::ldexp(1., std::ilogb(extent) - 465);
    else if (extent != 0. && extent < 1e-100)
      unit = std::ldexp(1., (std::max)(std::ilogb(extent), -1020));
  }
};

} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_COORDINATE_FRAME_H
