// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FLOW_FLOW_STEP_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FLOW_FLOW_STEP_H

#include <CGAL/Point_set_flow/Curvature_defaults.h>
#include <CGAL/Point_set_flow/Diffusivity.h>
#include <CGAL/Point_set_flow/flows.h>
#include <CGAL/Point_set_flow/internal/neighbors/Block.h>
#include <CGAL/Point_set_flow/internal/neighbors/Surface.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// One explicit step of a flow: \f$u \leftarrow u + s\,\partial u / \partial t\f$ for all points
/// at once, so that the result does not depend on the order of the points or on threads.
/// \param points where the points are; `piece` receives where they are then
/// \param filtered_variation for each point, or null if the flow does not use it
/// \param unit the length of 1 in the piece, in the unit of the data, which the flow sees
template <typename ConcurrencyTag, typename Flow, typename Curvature>
void flow_step(const Array<Point_3>& points, Piece& piece, double filter_width,
               const Surface_state& state, const Curvature& curvature,
               const Array<double>* filtered_variation, const Flow& flow, const Diffusivity& g,
               double step_length, double unit, Progress& progress, double work)
{
  const auto step = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      piece.points[i] = points[i];
      if (!piece.constrained.empty() && piece.constrained[i])
        continue;
      const Curvature_3 c =
          curvature(piece.graph.neighborhood(points, i, filter_width, state.at(i)));
      const Flow_point_3 u = {c.normal, c.directional_curvature * unit, c.variation,
                              filtered_variation ? (*filtered_variation)[i] : c.variation,
                              (piece.reference[i] - points[i]) * unit};
      piece.points[i] = points[i] + flow(u, g) * (step_length / unit);
    }
  };
  for_each_block<ConcurrencyTag>(points.size(), progress, work, step);
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FLOW_FLOW_STEP_H
