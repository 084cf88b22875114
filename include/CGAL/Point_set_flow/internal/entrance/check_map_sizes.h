// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_ENTRANCE_CHECK_MAP_SIZES_H
#define CGAL_POINT_SET_FLOW_INTERNAL_ENTRANCE_CHECK_MAP_SIZES_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/entrance/Argument_check.h>

#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// Whether a property map knows how many values it has, and its keys are their numbers: those of
/// `Point_set_3` and `Surface_mesh` do. A map on a bare pointer does not.
template <typename Map, typename Key, typename = void>
struct Knows_its_size : std::false_type {};
template <typename Map, typename Key>
struct Knows_its_size<Map, Key,
                      std::void_t<decltype(std::size_t(std::declval<const Map&>().end() -
                                                       std::declval<const Map&>().begin()))>>
    : std::is_convertible<Key, std::size_t> {};

/// Throws if a property map has no values for some of the points because it was made for others.
template <typename PointRange, typename Map>
void check_map_size(const PointRange& points, const Map& map, const char* argument,
                    const Argument_check& check)
{
  if constexpr (Knows_its_size<Map, std::decay_t<decltype(*points.begin())>>::value) {
    if constexpr (std::is_constructible<bool, const Map&>::value)
      if (!static_cast<bool>(map))
        check.refuse(argument, "null", "must be the map of a property");
    const std::size_t size = std::size_t(map.end() - map.begin());
    std::size_t i = 0;
    for (auto it = points.begin(); it != points.end(); ++it, ++i)
      if (std::size_t(*it) >= size)
        check.refuse(std::string("the size of ") + argument, size,
                     "points[" + std::to_string(i) + "] has the number " +
                         std::to_string(std::size_t(*it)));
  }
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_ENTRANCE_CHECK_MAP_SIZES_H
