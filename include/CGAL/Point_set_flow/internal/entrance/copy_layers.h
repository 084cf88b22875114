// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_ENTRANCE_COPY_LAYERS_H
#define CGAL_POINT_SET_FLOW_INTERNAL_ENTRANCE_COPY_LAYERS_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/entrance/Caller_maps.h>
#include <CGAL/Point_set_flow/internal/entrance/Frame.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <type_traits>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// The unit vector of a direction; null if there is none.
inline Vector_3 unit_or_null(double x, double y, double z)
{
  if (!(std::isfinite(x) && std::isfinite(y) && std::isfinite(z)))
    return NULL_VECTOR;
  const double largest = (std::max)({std::abs(x), std::abs(y), std::abs(z)});
  if (largest == 0.)
    return NULL_VECTOR;
  // squares of very large or small numbers would leave the range of `double`
  const Vector_3 v(x / largest, y / largest, z / largest);
  return v / std::sqrt(v.squared_length());
}

/// The given normals, which tell on which side of the surface is outside, in the order of the caller:
/// null vectors where they tell nothing, and empty if none of them does.
template <typename Maps>
Array<Vector_3> copy_sides(const Maps& maps)
{
  Array<Vector_3> sides;
  if (!maps.normal_map)
    return sides;
  sides.reserve(std::size_t(std::distance(maps.points.begin(), maps.points.end())));
  bool is_any_known = false;
  for (auto it = maps.points.begin(); it != maps.points.end(); ++it) {
    const typename Maps::Kernel_vector_3& n = get(*maps.normal_map, *it);
    sides.push_back(unit_or_null(to_double(n.x()), to_double(n.y()), to_double(n.z())));
    is_any_known = is_any_known || sides.back() != NULL_VECTOR;
  }
  return is_any_known ? sides : Array<Vector_3>();
}

/// The number of the scan of each point, in the order of the caller; empty if not given or the same for all.
template <typename Maps>
Array<std::uint32_t> copy_scans(const Maps& maps)
{
  Array<std::uint32_t> scans;
  if constexpr (Maps::has_scans) {
    const auto map = parameters::get_parameter(maps.np, internal_np::scan_map_t());
    typedef std::decay_t<decltype(get(map, *maps.points.begin()))> Number;
    static_assert(std::is_convertible<Number, std::uint32_t>::value &&
                      !std::is_floating_point<Number>::value,
                  "the value type of scan_map must be an integer");
    scans.reserve(std::size_t(std::distance(maps.points.begin(), maps.points.end())));
    for (auto it = maps.points.begin(); it != maps.points.end(); ++it)
      scans.push_back(static_cast<std::uint32_t>(get(map, *it)));
    if (std::adjacent_find(scans.begin(), scans.end(), std::not_equal_to<std::uint32_t>()) ==
        scans.end())
      return Array<std::uint32_t>();
  }
  return scans;
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_ENTRANCE_COPY_LAYERS_H
