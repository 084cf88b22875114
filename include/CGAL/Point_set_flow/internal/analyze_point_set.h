// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_ANALYZE_POINT_SET_H
#define CGAL_POINT_SET_FLOW_INTERNAL_ANALYZE_POINT_SET_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/Smoothing_report.h>
#include <CGAL/Point_set_flow/flows.h>
#include <CGAL/Point_set_flow/internal/entrance/copy_in.h>
#include <CGAL/Point_set_flow/internal/flow/Flow_plan.h>

#include <limits>
#include <optional>
#include <utility>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// The front half of `smooth_point_set()`: what it finds in the points, and plans.
template <typename ConcurrencyTag, typename PointRange, typename NamedParameters>
Smoothing_report analyze_point_set(const PointRange& points, const std::optional<unsigned int>& k,
                                   const NamedParameters& np, const Argument_check& check)
{
  const Flow_parameters parameters = read_parameters(k, np, check);
  const auto flow = value_of(np, internal_np::flow_t(), Balanced_flow());
  const auto curvature = value_of(np, internal_np::curvature_t(), Default_curvature());
  const Caller_maps<const PointRange, NamedParameters> maps(points, np, check);
  if (points.begin() == points.end())
    return Smoothing_report();
  Loops<ConcurrencyTag> loops(read_callback(np), stage_costs::analysis);
  try {
    return loops.in_isolation([&] {
      Input input(maps, check, loops);
      const Analyzed_points analyzed(std::move(input.points), 0, parameters.block_size, loops);
      const Flow_plan plan(analyzed, flow, curvature, parameters, input.frame.unit);
      loops.finish();
      return plan.report();
    });
  }
  catch (const Canceled&) {
    Smoothing_report nothing;
    nothing.noise = nothing.spacing = (std::numeric_limits<double>::quiet_NaN)();
    return nothing;
  }
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_ANALYZE_POINT_SET_H
