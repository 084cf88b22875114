// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_NEIGHBOR_H
#define CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_NEIGHBOR_H

#include <CGAL/license/Point_set_flow.h>

#include <cstdint>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// A neighbor and how far it is
struct Neighbor {
  double squared_distance;
  std::uint32_t index;
  bool operator<(const Neighbor& other) const // equal distances: the order of the points decides
  {
    return squared_distance < other.squared_distance ||
           (squared_distance == other.squared_distance && index < other.index);
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_NEIGHBOR_H
