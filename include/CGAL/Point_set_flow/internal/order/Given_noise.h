// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_ORDER_GIVEN_NOISE_H
#define CGAL_POINT_SET_FLOW_INTERNAL_ORDER_GIVEN_NOISE_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/parallel/Array.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// The noise that the caller gives, which replaces the estimate: one number for all points, or one
/// for each.
struct Given_noise {
  std::optional<double> of_all;
  Array<double> of_each; ///< empty if there is one number or none

  bool is_given() const { return of_all || !of_each.empty(); }

  /// The noise of one of the points, if it is given
  std::optional<double> of(std::size_t i) const
  {
    return of_each.empty() ? of_all : std::optional<double>(of_each[i]);
  }

  /// The noise of some of the points
  Given_noise of(const std::vector<std::uint32_t>& numbers) const
  {
    Given_noise part;
    part.of_all = of_all;
    if (!of_each.empty()) {
      part.of_each.reserve(numbers.size());
      for (const std::uint32_t i : numbers)
        part.of_each.push_back(of_each[i]);
    }
    return part;
  }
};

/// The mean of the noise of duplicates: the number itself if all are the same, whatever their order.
/// \param values not empty; are reordered
inline double mean_noise(std::vector<double>& values)
{
  std::sort(values.begin(), values.end()); // so that the order of the input does not matter
  double above_least = 0.;
  for (const double value : values)
    above_least += value - values.front();
  return values.front() + above_least / double(values.size());
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_ORDER_GIVEN_NOISE_H
