// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_PARALLEL_STAGE_COSTS_H
#define CGAL_POINT_SET_FLOW_INTERNAL_PARALLEL_STAGE_COSTS_H

#include <CGAL/license/Point_set_flow.h>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// What the stages cost relative to each other, for the progress
namespace stage_costs {
constexpr double order = 1., tree = .5, graph = 6., scale = 4., adapt = .5, prefilter = 1.,
                 planes = 1., sheets = 2., shrink = .5, step = 1., network = 3., relaxation = 1.;
constexpr double analysis = order + tree + graph + scale;
} // namespace stage_costs

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_PARALLEL_STAGE_COSTS_H
