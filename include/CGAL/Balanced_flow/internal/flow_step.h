// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BALANCED_FLOW_INTERNAL_FLOW_STEP_H
#define CGAL_BALANCED_FLOW_INTERNAL_FLOW_STEP_H

#include <CGAL/Balanced_flow/Curvature_3.h>
#include <CGAL/Balanced_flow/Diffusivity.h>
#include <CGAL/Balanced_flow/flows.h>
#include <CGAL/Balanced_flow/internal/Neighbor_graph.h>
#include <CGAL/Balanced_flow/internal/Point_buffer.h>
#include <CGAL/Balanced_flow/internal/Surface_state.h>

#include <cmath>
#include <numeric>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// One explicit step of a flow: \f$u \leftarrow u + s\,\partial u / \partial t\f$ for all points
/// at once, so that the result does not depend on the order of the points or on threads.
/// \param filtered_variation for each point, or null if the flow does not use it
/// \param unit the length of 1 in the buffer, in the unit of the data, which the flow sees
/// \param next receives the new points
/// \return the mean distance that the points moved
template <typename ConcurrencyTag, typename Flow, typename Curvature>
double flow_step(const Point_buffer& buffer, const Neighbor_graph& graph, double filter_width,
                 const Surface_state& state, const Curvature& curvature,
                 const std::vector<double>* filtered_variation, const Flow& flow,
                 const Diffusivity& g, double step_length, double unit, std::vector<Point_3>& next,
                 Progress& progress, double work)
{
  const std::vector<Point_3>& points = buffer.points;
  std::vector<double> moved((points.size() + block_size - 1) / block_size);

  const auto step = [&](std::size_t begin, std::size_t end) {
    double sum = 0.;
    for (std::size_t i = begin; i < end; ++i) {
      next[i] = points[i];
      if (!buffer.constrained.empty() && buffer.constrained[i])
        continue;
      const Curvature_3 c = curvature(graph.neighborhood(points, i, filter_width, state.at(i)));
      const Flow_point_3 u = {c.normal, c.directional_curvature * unit, c.variation,
                              filtered_variation ? (*filtered_variation)[i] : c.variation,
                              (buffer.reference[i] - points[i]) * unit};
      const Vector_3 motion = flow(u, g) * (step_length / unit);
      next[i] = points[i] + motion;
      sum += std::sqrt(motion.squared_length());
    }
    moved[begin / block_size] = sum;
  };
  for_each_block<ConcurrencyTag>(points.size(), progress, work, step);
  return std::accumulate(moved.begin(), moved.end(), 0.) / double(points.size());
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_BALANCED_FLOW_INTERNAL_FLOW_STEP_H
