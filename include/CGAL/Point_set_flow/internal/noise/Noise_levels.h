// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_NOISE_NOISE_LEVELS_H
#define CGAL_POINT_SET_FLOW_INTERNAL_NOISE_NOISE_LEVELS_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/fitting/median.h>
#include <CGAL/Point_set_flow/internal/neighbors/Block.h>
#include <CGAL/Point_set_flow/internal/noise/Noise_map.h>
#include <CGAL/Point_set_flow/internal/order/Given_noise.h>

#include <algorithm>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// The noise of a whole point set: the given one, or else the estimate.
struct Noise_levels {
  bool is_given;
  double typical, least, greatest;

  Noise_levels(const Given_noise& given, const Noise_map& estimate) : is_given(given.is_given())
  {
    if (given.of_all)
      typical = least = greatest = *given.of_all;
    else if (is_given) {
      std::vector<double> values(given.of_each.begin(), given.of_each.end());
      typical = median(values);
      const auto range = std::minmax_element(values.begin(), values.end());
      least = *range.first, greatest = *range.second;
    }
    else {
      typical = estimate.noise();
      std::tie(least, greatest) = estimate.noise_range();
    }
  }
};

/// The noise at each point of a block: the given one, which is taken from the block, or else the
/// estimate.
template <typename ConcurrencyTag>
Array<double> noise_at_points(Block& block, const Noise_map& estimate, Loops<ConcurrencyTag>& loops)
{
  return block.noise.is_given() ? block.noise.take(block.reference.size())
                                : estimate.noise_at(block.reference, loops);
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_NOISE_NOISE_LEVELS_H
