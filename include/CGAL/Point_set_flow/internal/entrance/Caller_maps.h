// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_ENTRANCE_CALLER_MAPS_H
#define CGAL_POINT_SET_FLOW_INTERNAL_ENTRANCE_CALLER_MAPS_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/entrance/check_map_sizes.h>
#include <CGAL/Point_set_flow/internal/entrance/named_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/property_map.h>

#include <optional>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

template <typename PointRange, typename = void>
struct Has_own_normals : std::false_type {};
template <typename PointRange>
struct Has_own_normals<PointRange,
                       std::void_t<decltype(std::declval<PointRange&>().has_normal_map())>>
    : std::true_type {};

/// The normal map, given by name or, in a `Point_set_3`, its own; empty where there are no normals.
///
/// \cgal's helper does not serve here: to find the map of a `Point_set_3` it adds one from \cgal 6.0 on.
template <typename NormalMap, typename PointRange, typename NamedParameters>
std::optional<NormalMap> find_normal_map(PointRange& points, const NamedParameters& np)
{
  if constexpr (is_given<NamedParameters, CGAL::internal_np::normal_t>) {
    const NormalMap map = parameters::get_parameter(np, CGAL::internal_np::normal_map);
    // Point_set_3::parameters() names a normal map even if the point set has no normals; such a
    // map is false as a condition
    if constexpr (std::is_constructible<bool, const NormalMap&>::value)
      if (!static_cast<bool>(map))
        return std::nullopt;
    return map;
  }
  else if constexpr (Has_own_normals<PointRange>::value) {
    if (points.has_normal_map())
      return points.normal_map();
  }
  return std::nullopt;
}

/// The point range of the caller with the property maps that read and write it.
/// \tparam PointRange may be constant, and is then not written
template <typename PointRange, typename NamedParameters>
class Caller_maps {
  typedef Point_set_processing_3_np_helper<std::remove_const_t<PointRange>, NamedParameters>
      NP_helper;

  static auto find_point_map(PointRange& points, const NamedParameters& np)
  {
    if constexpr (std::is_const<PointRange>::value)
      return NP_helper::get_const_point_map(points, np);
    else
      return NP_helper::get_point_map(points, np);
  }

public:
  typedef typename NP_helper::Geom_traits::FT FT;
  typedef typename NP_helper::Geom_traits::Point_3 Kernel_point_3;
  typedef typename NP_helper::Geom_traits::Vector_3 Kernel_vector_3;
  typedef decltype(find_point_map(std::declval<PointRange&>(),
                                  std::declval<const NamedParameters&>())) Point_map;
  typedef typename NP_helper::Normal_map Normal_map;

  static constexpr bool has_constraints =
      is_given<NamedParameters, CGAL::internal_np::point_is_constrained_t>;
  static constexpr bool has_start = is_given<NamedParameters, internal_np::initial_point_map_t>;
  static constexpr bool has_noise_map = is_given_as_map<NamedParameters, internal_np::noise_t>;
  static constexpr bool has_scans = is_given<NamedParameters, internal_np::scan_map_t>;
  static constexpr bool has_strength =
      is_given<NamedParameters, internal_np::feature_strength_map_t>;

  PointRange& points;
  const NamedParameters& np;
  Point_map point_map;
  std::optional<Normal_map> normal_map;

  /// Throws if one of the maps is too small for the points.
  Caller_maps(PointRange& points_, const NamedParameters& np_, const Argument_check& check)
      : points(points_), np(np_), point_map(find_point_map(points, np))
  {
    normal_map = find_normal_map<Normal_map>(points, np);
    const auto check_size = [&](auto tag, const char* argument) {
      if constexpr (is_given<NamedParameters, decltype(tag)>)
        check_map_size(points, parameters::get_parameter(np, tag), argument, check);
    };
    check_size(CGAL::internal_np::point_t(), "point_map");
    check_size(CGAL::internal_np::point_is_constrained_t(), "point_is_constrained_map");
    check_size(internal_np::initial_point_map_t(), "initial_point_map");
    check_size(internal_np::feature_strength_map_t(), "feature_strength_map");
    check_size(internal_np::noise_t(), "noise");
    check_size(internal_np::scan_map_t(), "scan_map");
    if (normal_map)
      check_map_size(points, *normal_map, "normal_map", check);
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_ENTRANCE_CALLER_MAPS_H
