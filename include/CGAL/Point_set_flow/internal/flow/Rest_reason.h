// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FLOW_REST_REASON_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FLOW_REST_REASON_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/Smoothing_report.h>

#include <cstddef>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// Why a point did not move, if it did not. One byte: there is one for each point.
enum class Rest_reason : unsigned char { CONSTRAINED, ISOLATED, NO_NOISE, OTHER };

/// Where the report counts the points that did not move for that reason
inline std::size_t& count_of(Smoothing_report& report, Rest_reason reason)
{
  switch (reason) {
  case Rest_reason::CONSTRAINED:
    return report.number_of_constrained_points;
  case Rest_reason::ISOLATED:
    return report.number_of_isolated_points;
  case Rest_reason::NO_NOISE:
    return report.number_of_points_without_noise;
  default:
    return report.number_of_points_at_rest;
  }
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FLOW_REST_REASON_H
