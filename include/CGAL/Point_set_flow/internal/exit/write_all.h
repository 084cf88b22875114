// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_EXIT_WRITE_ALL_H
#define CGAL_POINT_SET_FLOW_INTERNAL_EXIT_WRITE_ALL_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/entrance/named_parameters.h>
#include <CGAL/Point_set_flow/internal/exit/Map_writer.h>
#include <CGAL/Point_set_flow/internal/parallel/Array.h>
#include <CGAL/property_map.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// Writes points, normals and feature strengths to the maps of the caller: all of them, or none if
/// one of the maps throws.
/// \param strength of the distinct points; not used if there is no map for it
/// \param site_of for each point, where it is in `strength`
template <typename Maps>
void write_all(Maps& maps, std::vector<typename Maps::Kernel_point_3> points,
               std::vector<typename Maps::Kernel_vector_3> normals, const Array<double>& strength,
               const std::vector<std::uint32_t>& site_of)
{
  const auto write = [](auto&... writers) {
    (writers.write(), ...);
    (writers.keep(), ...);
  };
  Map_writer point_writer(maps.points, &maps.point_map, std::move(points));
  Map_writer normal_writer(maps.points, maps.normal_map ? &*maps.normal_map : nullptr,
                           std::move(normals));
  if constexpr (Maps::has_strength) {
    auto map = parameters::get_parameter(maps.np, internal_np::feature_strength_map_t());
    typedef typename boost::property_traits<decltype(map)>::value_type Number;
    std::vector<Number> values;
    values.reserve(site_of.size());
    for (const std::uint32_t site : site_of)
      values.push_back(static_cast<Number>(strength[site]));
    Map_writer strength_writer(maps.points, &map, std::move(values));
    write(point_writer, normal_writer, strength_writer);
  }
  else {
    static_cast<void>(strength);
    static_cast<void>(site_of);
    write(point_writer, normal_writer);
  }
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_EXIT_WRITE_ALL_H
