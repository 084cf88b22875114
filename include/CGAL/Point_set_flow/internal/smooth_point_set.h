// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_SMOOTH_POINT_SET_H
#define CGAL_POINT_SET_FLOW_INTERNAL_SMOOTH_POINT_SET_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/Smoothing_report.h>
#include <CGAL/Point_set_flow/flows.h>
#include <CGAL/Point_set_flow/internal/entrance/copy_in.h>
#include <CGAL/Point_set_flow/internal/entrance/named_parameters.h>
#include <CGAL/Point_set_flow/internal/exit/Output.h>
#include <CGAL/Point_set_flow/internal/flow/Block_runs.h>
#include <CGAL/Point_set_flow/internal/noise/Analyzed_points.h>

#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// What the maps of the caller and the limit of the movement need besides the points
template <typename Maps, typename Flow, typename Curvature>
Wanted_results wanted_results(const Maps& maps, const Flow& flow, const Curvature& curvature)
{
  return {maps.normal_map.has_value(), Maps::has_strength,
          stays_in_neighborhood(flow) && stays_in_neighborhood(curvature) && !Maps::has_start};
}

/// Smooths a point set, stage by stage: from the range and the maps of the caller to plain arrays,
/// through the flow, and back. Nothing of the caller is written before the flow has ended.
template <typename ConcurrencyTag, typename PointRange, typename NamedParameters>
double smooth_point_set(PointRange& points, const std::optional<unsigned int>& k,
                        const NamedParameters& np)
{
  const Argument_check check("CGAL::balanced_flow_smooth_point_set");
  const Flow_parameters parameters = read_parameters(k, np, check);
  const auto flow = value_of(np, internal_np::flow_t(), Balanced_flow());
  const auto curvature = value_of(np, internal_np::curvature_t(), Default_curvature());
  typedef Caller_maps<PointRange, NamedParameters> Maps;
  Maps maps(points, np, check);
  if (points.begin() == points.end()) {
    write_report(Smoothing_report(), np);
    return 0.;
  }
  const Wanted_results wanted = wanted_results(maps, flow, curvature);
  const std::size_t size = likely_size(parameters, Defaults_of<decltype(curvature)>::get(),
                                       std::size_t(std::distance(points.begin(), points.end())));
  Loops<ConcurrencyTag> loops(read_callback(np),
                              total_cost(parameters, flow, curvature, wanted, size));
  try {
    return loops.in_isolation([&] {
      Input input(maps, check, loops);
      Analyzed_points analyzed(std::move(input.points), size, parameters.block_size, loops);
      const Flow_plan plan(analyzed, flow, curvature, parameters, input.frame.unit);
      Smoothing_report report = plan.report();

      const Flow_result result =
          Block_runs(plan, flow, curvature, wanted, loops)(analyzed, parameters.block_size);
      report.last_movement = result.moved * input.frame.unit;
      if (!std::isfinite(report.last_movement))
        check.diverges();

      Output<Maps> output(maps, input.frame, result, analyzed.buffer().site_of, report, check,
                          loops);
      loops.finish();
      output.write();
      write_report(report, np);
      return report.last_movement;
    });
  }
  catch (const Canceled&) {
    return (std::numeric_limits<double>::quiet_NaN)();
  }
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_SMOOTH_POINT_SET_H
