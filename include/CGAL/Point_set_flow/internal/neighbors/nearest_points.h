// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_NEAREST_POINTS_H
#define CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_NEAREST_POINTS_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/neighbors/Candidates.h>
#include <CGAL/Point_set_flow/internal/neighbors/Neighbor_query.h>
#include <CGAL/Point_set_flow/internal/parallel/Loops.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// The point of a tree that is nearest to each place. A few places at a time have nearly the same points around.
/// \param places follow each other in space
/// \pre the tree has points
template <typename ConcurrencyTag>
Array<std::uint32_t> nearest_points(const Neighbor_tree& tree, const Array<Point_3>& places,
                                    Loops<ConcurrencyTag>& loops)
{
  Array<std::uint32_t> nearest(places.size());
  loops.for_each_chunk(places.size(), [&](std::size_t begin, std::size_t end) {
    const std::size_t group_size = 32;
    Neighbor_query query(tree, 2); // the nearest one may be in the same place
    Candidates candidates(tree);
    Eigen::ArrayXd squared;
    while (begin < end) {
      const std::vector<Neighbor>& found = query(places[begin]);
      const double far = std::sqrt(found.back().squared_distance);
      candidates.start_box(places[begin]);
      std::size_t next = begin + 1;
      while (next < end && next < begin + group_size && candidates.grow_box(places[next], far))
        ++next;
      if (next == begin + 1) { // there may be many points in the ball around a place far away
        nearest[begin++] = found.front().index;
        continue;
      }
      const double rounding = 1e-12, across = std::sqrt(3.) * far; // the box
      candidates.collect((far + across) * (1. + rounding) + (std::numeric_limits<double>::min)(),
                         tree.points().size());
      squared.resize((std::max)(squared.size(), Eigen::Index(candidates.size())));
      for (; begin < next; ++begin) {
        candidates.squared_distances(places[begin], squared);
        Eigen::Index best = 0; // the first one of several at the same distance
        for (Eigen::Index j = 1; j < Eigen::Index(candidates.size()); ++j)
          best = squared[j] < squared[best] ? j : best;
        nearest[begin] = candidates.site(std::size_t(best));
      }
    }
  });
  return nearest;
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_NEAREST_POINTS_H
