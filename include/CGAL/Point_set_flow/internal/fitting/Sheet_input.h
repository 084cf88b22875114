// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FITTING_SHEET_INPUT_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FITTING_SHEET_INPUT_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/fitting/Network_input.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// What is seen of a point before the first step to tell whether its neighbors are those of two sheets, and on
/// which one it is: heights above the tangent planes, in their standard deviation, and what the round
/// before found of the neighbors.
struct Sheet_input : Network_input<3, 3, 4, 2> {
  /// \pre `neighborhood.has_sheets()`; there are neighbors
  [[gnu::flatten]] explicit Sheet_input(const Neighborhood_3& neighborhood)
      : Network_input(neighborhood)
  {
    for (std::size_t i = 0; i < std::size_t(size); ++i) {
      const Sheet_evidence& found = neighborhood.sheets(spread(neighborhood, i));
      at(even[2], i) = found.two_sheets;
      at(odd[2], i) = found.side;
    }
    read_edges(neighborhood);
    Lanes heights = Lanes::Zero(), squares = Lanes::Zero();
    for (const Lanes& height : odd[0])
      heights += height;
    const float mean = heights.sum() / float(size);
    for (std::size_t g = 0; g < groups(); ++g) {
      const Lanes difference = (odd[0][g] - mean) * mask[g];
      squares += difference * difference;
    }
    const float least = .001f; // in radii
    const float unit = (std::max)(std::sqrt(squares.sum() / float(size)), least);
    squash(odd[0], unit);
    squash(odd[1], unit);
    const Sheet_evidence& own = neighborhood.sheets();
    of_point_even = {
        std::log(unit), limited(neighborhood.excess_kurtosis(), 2.),
        limited(std::log(neighborhood.noise() / (neighborhood.radius() * double(unit))), 3.),
        own.two_sheets};
    of_point_odd = {squashed(-mean / unit), own.side};
  }

  /// Outputs of the network as inputs of the next round
  using Network_input::squashed;
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FITTING_SHEET_INPUT_H
