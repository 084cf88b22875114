// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FLOW_PREFILTER_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FLOW_PREFILTER_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/neighbors/Neighbor_graph.h>

#include <cstddef>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// \f$M_\sigma = G_\sigma \times u\f$, section 2.3 and the first line of the loop in Table 1: each
/// point becomes the Gaussian-weighted mean of itself and its neighbors.
template <typename ConcurrencyTag>
void prefilter(const Array<Point_3>& points, const Neighbor_graph& graph, double filter_width,
               Array<Point_3>& filtered, Loops<ConcurrencyTag>& loops)
{
  filtered.resize(points.size());
  const auto filter = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Neighborhood_3 neighborhood = graph.neighborhood(points, i, filter_width);
      Vector_3 sum(0., 0., 0.);
      double weights = 1.; // of the point itself
      for (std::size_t j = 0; j < neighborhood.size(); ++j) {
        const Vector_3 d = neighborhood[j] - points[i];
        const double weight = neighborhood.gaussian(d.squared_length());
        sum = sum + weight * d;
        weights += weight;
      }
      filtered[i] = points[i] + sum / weights;
    }
  };
  loops.for_each_chunk(points.size(), filter);
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FLOW_PREFILTER_H
