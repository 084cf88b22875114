// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_SMOOTH_POINT_SET_H
#define CGAL_POINT_SET_FLOW_INTERNAL_SMOOTH_POINT_SET_H

#include <CGAL/Point_set_flow/Tangent_plane_curvature.h>
#include <CGAL/Point_set_flow/flows.h>
#include <CGAL/Point_set_flow/internal/flow/Flow_parameters.h>
#include <CGAL/Point_set_flow/internal/order/Point_buffer.h>
#include <CGAL/Point_set_flow/internal/entrance/check_map_sizes.h>
#include <CGAL/Point_set_flow/internal/entrance/copy_in.h>
#include <CGAL/Point_set_flow/internal/exit/Map_writer.h>
#include <CGAL/Point_set_flow/internal/flow/Block_runs.h>
#include <CGAL/Point_set_flow/parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/property_map.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

template <typename T, typename Tag, typename Base>
std::true_type test_named_parameters(const Named_function_parameters<T, Tag, Base>*);
std::false_type test_named_parameters(const void*);

/// Whether a type is a pack of named parameters: tells an `int` meant as `k` from one.
template <typename T>
using Is_named_parameters = decltype(test_named_parameters(static_cast<const T*>(nullptr)));

template <typename NamedParameters, typename Tag>
constexpr bool is_given = !parameters::is_default_parameter<NamedParameters, Tag>::value;

/// The value of a named parameter if it is given, else the default.
template <typename NamedParameters, typename Tag, typename Default>
auto value_of(const NamedParameters& np, Tag tag, const Default& otherwise)
{
  if constexpr (is_given<NamedParameters, Tag>)
    return parameters::get_parameter(np, tag);
  else
    return otherwise;
}

template <typename NamedParameters>
Options read_options(const std::optional<unsigned int>& k, const NamedParameters& np)
{
  namespace cgal_np = CGAL::internal_np;
  Options options;
  options.k = k;
  options.neighbor_radius = to_double(value_of(np, cgal_np::neighbor_radius, 0.));
  if constexpr (is_given<NamedParameters, cgal_np::number_of_iterations_t>)
    options.number_of_iterations = to_count(
        "number_of_iterations", parameters::get_parameter(np, cgal_np::number_of_iterations));
  if constexpr (is_given<NamedParameters, cgal_np::sharpness_angle_t>)
    options.sharpness_angle = to_double(parameters::get_parameter(np, cgal_np::sharpness_angle));
  if constexpr (is_given<NamedParameters, internal_np::feature_threshold_t>)
    options.feature_threshold =
        to_double(parameters::get_parameter(np, internal_np::feature_threshold_t()));
  if constexpr (is_given<NamedParameters, internal_np::filter_width_t>)
    options.filter_width = to_double(parameters::get_parameter(np, internal_np::filter_width_t()));
  if constexpr (is_given<NamedParameters, internal_np::step_length_t>)
    options.step_length = to_double(parameters::get_parameter(np, internal_np::step_length_t()));
  options.update_period = to_count(
      "update_period", value_of(np, internal_np::update_period_t(), options.update_period));
  options.block_size =
      to_count("block_size", value_of(np, internal_np::block_size_t(), options.block_size));
  options.check();
  return options;
}

template <typename PointRange, typename = void>
struct Has_own_normals : std::false_type {};
template <typename PointRange>
struct Has_own_normals<PointRange,
                       std::void_t<decltype(std::declval<PointRange&>().has_normal_map())>>
    : std::true_type {};

/// The normal map, given by name or, in a `Point_set_3`, its own; empty where there are no normals.
///
/// \cgal's helper is no use here: to find the map of a `Point_set_3` it adds one from \cgal 6.0 on.
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

/// The normal on the side of the given one. A point without a plane of neighbors keeps that one.
inline Vector_3 oriented_normal(const Vector_3& normal, const Vector_3& given)
{
  const double length = std::sqrt(given.squared_length());
  if (normal == NULL_VECTOR)
    return length > 0. && std::isfinite(length) ? given / length : Vector_3(0., 0., 1.);
  return normal * given < 0. ? -normal : normal;
}

inline Vector_3 not_longer(const Vector_3& d, double length)
{
  return d.squared_length() > length * length ? d * (length / std::sqrt(d.squared_length())) : d;
}

[[noreturn]] inline void throw_divergence(const std::string& where)
{
  throw std::overflow_error("CGAL::balanced_flow_smooth_point_set: the flow diverges" + where +
                            ", try a smaller step_length");
}

/// A point that moves, but not out of the range of its coordinates: the largest `float` stands for
/// "nothing there" in some scans. If it is not to stay near, that is an error.
template <typename Kernel_point_3>
Kernel_point_3 moved(const Kernel_point_3& p, const Vector_3& d, bool stays_near, std::size_t i)
{
  const auto sum = [&](auto coordinate, double distance) {
    typedef decltype(coordinate) FT;
    const FT moved = coordinate + FT(distance);
    const bool is_finite = std::isfinite(to_double(moved));
    if (!std::isfinite(distance) || !(is_finite || stays_near))
      throw_divergence(" at points[" + std::to_string(i) + "]");
    return is_finite ? moved : coordinate;
  };
  return Kernel_point_3(sum(p.x(), d.x()), sum(p.y(), d.y()), sum(p.z(), d.z()));
}

/// Throws if one of the maps is too small for the points, before anything else is done.
template <typename PointRange, typename NamedParameters>
void check_sizes(const PointRange& points, const NamedParameters& np)
{
  const auto check = [&](auto tag, const char* argument) {
    if constexpr (is_given<NamedParameters, decltype(tag)>)
      check_size(points, parameters::get_parameter(np, tag), argument);
  };
  check(CGAL::internal_np::point_t(), "point_map");
  check(CGAL::internal_np::point_is_constrained_t(), "point_is_constrained_map");
  check(internal_np::initial_point_map_t(), "initial_point_map");
  check(internal_np::feature_strength_map_t(), "feature_strength_map");
}

/// From the range and the maps of the caller to plain arrays, through the flow, and back.
/// Nothing of the caller is written before the flow has ended.
template <typename ConcurrencyTag, typename PointRange, typename NamedParameters>
double smooth_point_set(PointRange& points, const std::optional<unsigned int>& k,
                        const NamedParameters& np)
{
  typedef Point_set_processing_3_np_helper<PointRange, NamedParameters> NP_helper;
  typedef typename NP_helper::Geom_traits::FT FT;
  typedef typename NP_helper::Geom_traits::Point_3 Kernel_point_3;
  typedef typename NP_helper::Geom_traits::Vector_3 Kernel_vector_3;

  const Options options = read_options(k, np);
  const auto flow = value_of(np, internal_np::flow_t(), Balanced_flow());
  const auto curvature = value_of(np, internal_np::curvature_t(), Tangent_plane_curvature());
  const std::function<bool(double)> callback =
      value_of(np, CGAL::internal_np::callback, std::function<bool(double)>());
  auto point_map = NP_helper::get_point_map(points, np);
  auto normal_map = find_normal_map<typename NP_helper::Normal_map>(points, np);
  check_sizes(points, np);
  if (normal_map)
    check_size(points, *normal_map, "normal_map");

  if (points.begin() == points.end())
    return 0.;
  Frame frame;
  std::vector<char> fixed;
  if constexpr (is_given<NamedParameters, CGAL::internal_np::point_is_constrained_t>) {
    const auto map = parameters::get_parameter(np, CGAL::internal_np::point_is_constrained);
    for (auto it = points.begin(); it != points.end(); ++it)
      fixed.push_back(get(map, *it) ? 1 : 0);
  }

  try {
    typedef std::decay_t<decltype(flow)> Flow;
    typedef std::decay_t<decltype(curvature)> Curvature;
    typedef Flow_plan<Flow, Curvature> Plan;
    constexpr bool stays_near = Stays_in_neighborhood<Flow, Curvature>::value &&
                                !is_given<NamedParameters, internal_np::initial_point_map_t>;
    constexpr bool with_strength = is_given<NamedParameters, internal_np::feature_strength_map_t>;
    const unsigned int steps =
        options.number_of_iterations.value_or(Defaults_of<Curvature>::get().number_of_iterations);
    Progress progress(callback, work::total(steps, Plan::uses_normals, Plan::prefiltered,
                                            int(normal_map.has_value()) + int(with_strength)));
    progress.advance(0.);

    std::vector<std::uint32_t> site_of;
    const auto compute = [&] {
      Array<Point_3> input = copy_in<Kernel_point_3>(points, point_map, "points"), start;
      frame = find_frame(ConcurrencyTag(), input, progress);
      move_to_core(input, frame);
      if constexpr (is_given<NamedParameters, internal_np::initial_point_map_t>) {
        const auto start_map = parameters::get_parameter(np, internal_np::initial_point_map_t());
        start = copy_in<Kernel_point_3>(points, start_map, "initial_point_map");
        move_to_core(start, frame);
      }
      Point_buffer buffer(ConcurrencyTag(), input, start, fixed, progress, work::order);
      input = Array<Point_3>(); // memory
      start = Array<Point_3>();
      site_of.swap(buffer.site_of);
      return run_pieces(ConcurrencyTag(), buffer, flow, curvature, options, frame.unit,
                        {normal_map.has_value(), with_strength, stays_near}, progress);
    };
    const Flow_result result = in_isolation<ConcurrencyTag>(compute);
    if (!std::isfinite(result.moved * frame.unit))
      throw_divergence("");

    std::vector<Kernel_vector_3> new_normals;
    if (normal_map) {
      std::size_t i = 0;
      for (auto it = points.begin(); it != points.end(); ++it, ++i) {
        const Kernel_vector_3& given = get(*normal_map, *it);
        const Vector_3 n = oriented_normal(
            result.normals[site_of[i]],
            Vector_3(to_double(given.x()), to_double(given.y()), to_double(given.z())));
        new_normals.push_back(Kernel_vector_3(FT(n.x()), FT(n.y()), FT(n.z())));
      }
    }

    // in the order of the caller: to jump about in memory is work for threads
    Array<Point_3> flowed(site_of.size());
    Array<double> radii(result.radii.empty() ? 0 : flowed.size());
    const auto gather = [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        flowed[i] = result.points[site_of[i]];
        if (stays_near)
          radii[i] = result.radii[site_of[i]];
      }
    };
    in_isolation<ConcurrencyTag>(
        [&] { for_each_block<ConcurrencyTag>(flowed.size(), progress, 0., gather); });
    std::vector<Kernel_point_3> new_points;
    new_points.reserve(flowed.size());
    std::size_t i = 0;
    for (auto it = points.begin(); it != points.end(); ++it, ++i) {
      // adding the movement, rather than going back from the frame, keeps all digits of points
      // that do not move
      const Kernel_point_3& p = get(point_map, *it);
      const Point_3 before =
          frame.to_core(Point_3(to_double(p.x()), to_double(p.y()), to_double(p.z())));
      Vector_3 d = flowed[i] - before;
      if (stays_near)
        d = not_longer(d, radii[i]);
      d = d * frame.unit;
      new_points.push_back(moved(p, d, stays_near, i));
    }

    progress.finish();
    const auto write = [](auto&... writers) {
      (writers.write(), ...);
      (writers.keep(), ...);
    };
    Map_writer point_writer(points, &point_map, std::move(new_points));
    Map_writer normal_writer(points, normal_map ? &*normal_map : nullptr, std::move(new_normals));
    if constexpr (with_strength) {
      auto map = parameters::get_parameter(np, internal_np::feature_strength_map_t());
      typedef typename boost::property_traits<decltype(map)>::value_type Number;
      std::vector<Number> values;
      for (const std::uint32_t site : site_of)
        values.push_back(static_cast<Number>(result.feature_strength[site]));
      Map_writer strength_writer(points, &map, std::move(values));
      write(point_writer, normal_writer, strength_writer);
    }
    else
      write(point_writer, normal_writer);
    return result.moved * frame.unit;
  }
  catch (const Cancelled&) {
    return (std::numeric_limits<double>::quiet_NaN)();
  }
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_SMOOTH_POINT_SET_H
