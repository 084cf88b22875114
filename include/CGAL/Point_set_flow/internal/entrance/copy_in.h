// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_ENTRANCE_COPY_IN_H
#define CGAL_POINT_SET_FLOW_INTERNAL_ENTRANCE_COPY_IN_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/entrance/Caller_maps.h>
#include <CGAL/Point_set_flow/internal/entrance/Frame.h>
#include <CGAL/Point_set_flow/internal/entrance/copy_layers.h>
#include <CGAL/Point_set_flow/internal/entrance/copy_noise.h>
#include <CGAL/Point_set_flow/internal/order/Input_points.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// Copies points as they are; throws if a coordinate is not finite.
template <typename Kernel_point_3, typename PointRange, typename PointMap>
Array<Point_3> copy_points(const PointRange& points, PointMap point_map,
                           const std::string& argument, const Argument_check& check)
{
  Array<Point_3> copy;
  copy.reserve(std::size_t(std::distance(points.begin(), points.end())));
  for (auto it = points.begin(); it != points.end(); ++it) {
    const Kernel_point_3& p = get(point_map, *it);
    copy.emplace_back(to_double(p.x()), to_double(p.y()), to_double(p.z()));
    const Point_3& c = copy.back();
    if (!(std::isfinite(c.x()) && std::isfinite(c.y()) && std::isfinite(c.z()))) {
      std::ostringstream value;
      value << "(" << c.x() << ", " << c.y() << ", " << c.z() << ")";
      check.refuse(argument + "[" + std::to_string(copy.size() - 1) + "]", value.str(),
                   "coordinates must be finite");
    }
  }
  if (copy.size() > (std::numeric_limits<std::uint32_t>::max)())
    throw std::length_error(check.function() + ": more than 2^32 - 1 points");
  return copy;
}

/// The points of the caller in the coordinates of the core.
/// \param frame receives these coordinates
/// \param given the frame, if it is not to be found
/// \pre there are points
template <typename Maps, typename ConcurrencyTag>
Array<Point_3> copy_reference(const Maps& maps, Frame& frame, const Argument_check& check,
                              Loops<ConcurrencyTag>& loops, const Coordinate_frame* given = nullptr)
{
  loops.ask(); // before the caller's maps are read
  Array<Point_3> reference =
      copy_points<typename Maps::Kernel_point_3>(maps.points, maps.point_map, "points", check);
  frame = given ? Frame(*given) : find_frame(reference, loops);
  move_to_core(reference, frame);
  return reference;
}

/// A private copy of what the caller gives, in the coordinates of the core.
struct Input {
  Frame frame;
  Input_points points;

  /// \param given the frame, if it is not to be found
  /// \pre there are points
  template <typename Maps, typename ConcurrencyTag>
  Input(const Maps& maps, const Argument_check& check, Loops<ConcurrencyTag>& loops,
        const Coordinate_frame* given = nullptr)
  {
    points.reference = copy_reference(maps, frame, check, loops, given);
    if constexpr (Maps::has_constraints) {
      const auto map = parameters::get_parameter(maps.np, CGAL::internal_np::point_is_constrained);
      for (auto it = maps.points.begin(); it != maps.points.end(); ++it)
        points.constrained.push_back(get(map, *it) ? 1 : 0);
    }
    if constexpr (Maps::has_start) {
      const auto map = parameters::get_parameter(maps.np, internal_np::initial_point_map_t());
      points.start =
          copy_points<typename Maps::Kernel_point_3>(maps.points, map, "initial_point_map", check);
      move_to_core(points.start, frame);
    }
    points.noise = copy_noise(maps, frame, check);
    points.sides = copy_sides(maps);
    points.scans = copy_scans(maps);
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_ENTRANCE_COPY_IN_H
