// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FLOW_FLOW_PARAMETERS_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FLOW_FLOW_PARAMETERS_H

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// The error that every check of this package throws: names the argument and shows the value.
template <typename T>
[[noreturn]] void throw_bad_argument(const std::string& argument, const T& value,
                                     const std::string& requirement)
{
  std::ostringstream message;
  message.precision(17);
  message << "CGAL::balanced_flow_smooth_point_set: " << argument << " is " << value << ", but "
          << requirement;
  throw std::invalid_argument(message.str());
}

/// The parameters of a run as plain numbers. Documented at `balanced_flow_smooth_point_set()`.
/// What is not set is chosen from the data, or suits the curvature estimator.
struct Options {
  std::optional<unsigned int> k;
  double neighbor_radius = 0.; // 0: no limit
  std::optional<unsigned int> number_of_iterations;
  std::optional<double> sharpness_angle;
  std::optional<double> feature_threshold;
  std::optional<double> filter_width;
  std::optional<double> step_length;
  unsigned int update_period = 4; // 0: never
  std::size_t block_size = std::size_t(1) << 22;

  void check() const
  {
    if (k && *k < 2)
      throw_bad_argument("k", *k, "at least 2 neighbors are needed");
    if (k && *k > unsigned((std::numeric_limits<std::int32_t>::max)())) // such as -1
      throw_bad_argument("k", *k, "must be a number from 2 to 2147483647");
    check_not_negative("neighbor_radius", neighbor_radius);
    if (block_size == 0)
      throw_bad_argument("block_size", block_size, "must be positive");
    if (sharpness_angle && !(*sharpness_angle > 0. && *sharpness_angle <= 180.))
      throw_bad_argument("sharpness_angle", *sharpness_angle, "must be in (0, 180] degrees");
    if (feature_threshold)
      check_not_negative("feature_threshold", *feature_threshold);
    if (filter_width)
      check_not_negative("filter_width", *filter_width);
    if (step_length)
      check_not_negative("step_length", *step_length);
  }

private:
  static void check_not_negative(const char* argument, double value)
  {
    if (!(value >= 0. && std::isfinite(value)))
      throw_bad_argument(argument, value, "must be finite and not negative");
  }
};

/// Converts a number of any type that a user may pass for a count.
template <typename Number>
unsigned int to_count(const char* argument, Number value)
{
  static_assert(std::is_arithmetic<Number>::value, "a number is expected here");
  const double number = static_cast<double>(value);
  if (!(number >= 0. && number <= double((std::numeric_limits<std::int32_t>::max)()) &&
        std::floor(number) == number))
    throw_bad_argument(argument, value, "must be a whole number from 0 to 2147483647");
  return static_cast<unsigned int>(value);
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FLOW_FLOW_PARAMETERS_H
