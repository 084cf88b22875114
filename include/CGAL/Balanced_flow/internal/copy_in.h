// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BALANCED_FLOW_INTERNAL_COPY_IN_H
#define CGAL_BALANCED_FLOW_INTERNAL_COPY_IN_H

#include <CGAL/Balanced_flow/Vector_types.h>
#include <CGAL/Balanced_flow/internal/Options.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

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

  template <typename Point>
  Point_3 to_core(const Point& p) const
  {
    return Point_3((to_double(p.x()) - center[0]) / unit, (to_double(p.y()) - center[1]) / unit,
                   (to_double(p.z()) - center[2]) / unit);
  }
};

/// Finds the frame of a range of points; throws if a coordinate is not finite.
template <typename PointRange, typename PointMap>
Frame find_frame(const PointRange& points, PointMap point_map, const std::string& argument)
{
  double low[3], high[3];
  std::size_t index = 0;
  for (auto it = points.begin(); it != points.end(); ++it, ++index) {
    const auto& p = get(point_map, *it);
    const double c[3] = {to_double(p.x()), to_double(p.y()), to_double(p.z())};
    for (int d = 0; d < 3; ++d) {
      if (!std::isfinite(c[d])) {
        std::ostringstream value;
        value << "(" << c[0] << ", " << c[1] << ", " << c[2] << ")";
        throw_bad_argument(argument + "[" + std::to_string(index) + "]", value.str(),
                           "coordinates must be finite");
      }
      low[d] = index == 0 ? c[d] : (std::min)(low[d], c[d]);
      high[d] = index == 0 ? c[d] : (std::max)(high[d], c[d]);
    }
  }
  Frame frame;
  double extent = 0.;
  for (int d = 0; d < 3 && index != 0; ++d) {
    frame.center[d] = low[d] / 2. + high[d] / 2.;
    extent = (std::max)(extent, high[d] / 2. - low[d] / 2.);
  }
  if (extent != 0. && (extent < 1e-100 || extent > 1e100))
    frame.unit = std::ldexp(1., std::ilogb(extent));
  return frame;
}

/// Copies the points of the caller into the coordinates of the core.
template <typename PointRange, typename PointMap>
std::vector<Point_3> copy_in(const PointRange& points, PointMap point_map, const Frame& frame)
{
  std::vector<Point_3> core;
  for (auto it = points.begin(); it != points.end(); ++it)
    core.push_back(frame.to_core(get(point_map, *it)));
  return core;
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_BALANCED_FLOW_INTERNAL_COPY_IN_H
