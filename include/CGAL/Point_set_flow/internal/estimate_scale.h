// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_ESTIMATE_SCALE_H
#define CGAL_POINT_SET_FLOW_INTERNAL_ESTIMATE_SCALE_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/Point_set_scale.h>
#include <CGAL/Point_set_flow/internal/entrance/copy_in.h>
#include <CGAL/Point_set_flow/internal/noise/Analyzed_points.h>

#include <functional>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// The noise and the spacing of a point set.
template <typename ConcurrencyTag, typename PointRange, typename NamedParameters>
Point_set_scale estimate_scale(const PointRange& points, const NamedParameters& np,
                               const Argument_check& check)
{
  const Caller_maps<const PointRange, NamedParameters> maps(points, np, check);
  if (points.begin() == points.end())
    return Point_set_scale();
  Loops<ConcurrencyTag> loops(std::function<bool(double)>(), stage_costs::analysis);
  return loops.in_isolation([&] {
    Frame frame;
    Input_points input;
    input.reference = copy_reference(maps, frame, check, loops);
    const Analyzed_points analyzed(std::move(input), 0, Flow_parameters().block_size, loops);
    const double noise = analyzed.scale_map().noise(), spacing = analyzed.scale_map().spacing();
    Point_set_scale scale;
    scale.noise = noise * frame.unit;
    scale.spacing = spacing * frame.unit;
    scale.k = Default_curvature::defaults().neighborhood_size(spacing > 0. ? noise / spacing : 0.);
    return scale;
  });
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_ESTIMATE_SCALE_H
