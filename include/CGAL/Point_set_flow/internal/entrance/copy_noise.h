// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_ENTRANCE_COPY_NOISE_H
#define CGAL_POINT_SET_FLOW_INTERNAL_ENTRANCE_COPY_NOISE_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/entrance/Caller_maps.h>
#include <CGAL/Point_set_flow/internal/entrance/Frame.h>
#include <CGAL/Point_set_flow/internal/order/Given_noise.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// The noise that the caller gives, in the unit of the core; throws if a value of a map is not finite
/// or is negative.
template <typename Maps>
Given_noise copy_noise(const Maps& maps, const Frame& frame, const Argument_check& check)
{
  // the squares of larger numbers would leave the range of `double`; the points do not extend as far
  const double largest = 1e150;
  const auto to_core = [&](double noise) { return (std::min)(noise / frame.unit, largest); };
  Given_noise noise;
  if constexpr (Maps::has_noise_map) {
    noise.of_each.reserve(std::size_t(std::distance(maps.points.begin(), maps.points.end())));
    const auto map = parameters::get_parameter(maps.np, internal_np::noise_t());
    for (auto it = maps.points.begin(); it != maps.points.end(); ++it) {
      const double value = static_cast<double>(get(map, *it));
      check.finite_and_not_negative("noise", noise.of_each.size(), value);
      noise.of_each.push_back(to_core(value));
    }
  }
  else if (const std::optional<double> value = number(maps.np, internal_np::noise_t()))
    noise.of_all = to_core(*value); // checked with the other numbers
  return noise;
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_ENTRANCE_COPY_NOISE_H
