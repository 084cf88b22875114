// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_ENTRANCE_NAMED_PARAMETERS_H
#define CGAL_POINT_SET_FLOW_INTERNAL_ENTRANCE_NAMED_PARAMETERS_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/Learned_curvature.h>
#include <CGAL/Point_set_flow/Smoothing_report.h>
#include <CGAL/Point_set_flow/internal/entrance/Argument_check.h>
#include <CGAL/Point_set_flow/internal/flow/Flow_parameters.h>
#include <CGAL/Point_set_flow/parameters.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// The estimator, if the caller chooses none
typedef Learned_curvature Default_curvature;

template <typename T, typename Tag, typename Base>
std::true_type test_named_parameters(const Named_function_parameters<T, Tag, Base>*);
std::false_type test_named_parameters(const void*);

/// Whether a type is a pack of named parameters: distinguishes it from an `int` meant as `k`.
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

/// Whether a type is that of a property map, and not of a number.
template <typename T, typename = void>
struct Is_property_map : std::false_type {};
template <typename T>
struct Is_property_map<T, std::void_t<typename boost::property_traits<T>::key_type>>
    : std::true_type {};

/// Whether the value of a named parameter is a property map.
template <typename NamedParameters, typename Tag>
constexpr bool is_given_as_map = Is_property_map<std::decay_t<decltype(parameters::get_parameter(
    std::declval<const NamedParameters&>(), std::declval<const Tag&>()))>>::value;

template <typename NamedParameters>
std::function<bool(double)> read_callback(const NamedParameters& np)
{
  return value_of(np, CGAL::internal_np::callback, std::function<bool(double)>());
}

template <typename NamedParameters>
void write_report(const Smoothing_report& report, const NamedParameters& np)
{
  if constexpr (is_given<NamedParameters, internal_np::smoothing_report_t>) {
    Smoothing_report& to = parameters::get_parameter(np, internal_np::smoothing_report_t());
    to = report;
  }
  else
    static_cast<void>(report);
}

template <typename Number>
std::optional<double> to_optional(const Number& value)
{
  return to_double(value);
}
/// An empty one is the same as no parameter: whether a number is given need not be known at compile time.
template <typename Number>
std::optional<double> to_optional(const std::optional<Number>& value)
{
  return value ? to_optional(*value) : std::nullopt;
}

/// A number, if it is given.
template <typename NamedParameters, typename Tag>
std::optional<double> number(const NamedParameters& np, Tag tag)
{
  if constexpr (is_given<NamedParameters, Tag>)
    return to_optional(parameters::get_parameter(np, tag));
  else
    return std::nullopt;
}

inline void check_k(const Argument_check& check, unsigned int k)
{
  if (k < 2)
    check.refuse("k", k, "at least 2 neighbors are needed");
  if (k > unsigned((std::numeric_limits<std::int32_t>::max)())) // such as -1
    check.refuse("k", k, "must be a number from 2 to 2147483647");
}

/// Reads and checks the numbers among the named parameters.
template <typename NamedParameters>
Flow_parameters read_parameters(const std::optional<unsigned int>& k, const NamedParameters& np,
                                const Argument_check& check)
{
  namespace cgal_np = CGAL::internal_np;
  Flow_parameters read;
  if (k)
    check_k(check, *k);
  read.k = k;
  read.neighbor_radius = number(np, cgal_np::neighbor_radius).value_or(read.neighbor_radius);
  check.finite_and_not_negative("neighbor_radius", read.neighbor_radius);
  if constexpr (is_given<NamedParameters, cgal_np::number_of_iterations_t>)
    read.number_of_iterations = check.count(
        "number_of_iterations", parameters::get_parameter(np, cgal_np::number_of_iterations));
  read.number_of_relaxation_steps =
      check.count("number_of_relaxation_steps", value_of(np, cgal_np::number_of_relaxation_steps,
                                                         read.number_of_relaxation_steps));
  read.update_period = check.count(
      "update_period", value_of(np, internal_np::update_period_t(), read.update_period));
  read.block_size =
      check.count("block_size", value_of(np, internal_np::block_size_t(), read.block_size));
  if (read.block_size == 0)
    check.refuse("block_size", read.block_size, "must be positive");
  read.sharpness_angle = number(np, cgal_np::sharpness_angle);
  if (read.sharpness_angle && !(*read.sharpness_angle > 0. && *read.sharpness_angle <= 180.))
    check.refuse("sharpness_angle", *read.sharpness_angle, "must be in (0, 180] degrees");
  if constexpr (!is_given_as_map<NamedParameters, internal_np::noise_t>)
    if (const std::optional<double> noise = number(np, internal_np::noise_t()))
      check.finite_and_not_negative("noise", *noise);
  const auto length_or_ratio = [&](const char* argument, auto tag) {
    const std::optional<double> value = number(np, tag);
    if (value)
      check.finite_and_not_negative(argument, *value);
    return value;
  };
  read.feature_threshold = length_or_ratio("feature_threshold", internal_np::feature_threshold_t());
  read.filter_width = length_or_ratio("filter_width", internal_np::filter_width_t());
  read.step_length = length_or_ratio("step_length", internal_np::step_length_t());
  return read;
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_ENTRANCE_NAMED_PARAMETERS_H
