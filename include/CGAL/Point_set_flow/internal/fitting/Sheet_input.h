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
  [[gnu::flatten]] explicit Sheet_input(const Neighborhood_3& neighborhood) : Network_input(neighborhood)
  {
    for (int i = 0; i < size; ++i) {
      const Edge edge = read_edge(neighborhood, i);
      const Sheet_evidence& found = neighborhood.sheets(edge.neighbor);
      even[2][i] = found.two_sheets;
      odd[2][i] = found.side * static_cast<float>(edge.side);
    }
    const float mean = odd[0].sum() / float(size);
    const float variance = ((odd[0] - mean).square() * mask).sum() / float(size);
    const float least = .001f, unit = (std::max)(std::sqrt(variance), least); // in radii
    odd[0] = squashed(Edge_lanes(odd[0] / unit));
    odd[1] = squashed(Edge_lanes(odd[1] / unit));
    const Sheet_evidence& own = neighborhood.sheets();
    of_point_even << std::log(unit), limited(own.excess, 2.),
        limited(std::log(neighborhood.noise() / (neighborhood.radius() * double(unit))), 3.),
        own.two_sheets;
    of_point_odd << squashed(-mean / unit), own.side;
  }

  /// Outputs of the network as inputs of the next round
  using Network_input::squashed;
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FITTING_SHEET_INPUT_H
