// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FLOW_RESTING_POINTS_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FLOW_RESTING_POINTS_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/neighbors/Neighbor_graph.h>
#include <CGAL/Point_set_flow/internal/parallel/Array.h>

#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// Points that drop out of all steps, and the tangent planes that nobody needs for that reason.
class Resting_points {
  Array<char> m_needs_plane; // empty if no point rests

public:
  /// \param is_at_rest tells by its index whether a point rests until the last step
  template <typename Is_at_rest>
  void find(const Neighbor_graph& graph, std::size_t n, const Is_at_rest& is_at_rest)
  {
    std::size_t first = 0;
    while (first < n && !is_at_rest(first))
      ++first;
    if (first == n)
      return;
    m_needs_plane.assign(n, false);
    for (std::size_t i = 0; i < n; ++i) {
      if (is_at_rest(i))
        continue;
      m_needs_plane[i] = true;
      const Neighbor_numbers neighbors = graph.neighbors(i);
      for (std::size_t j = 0; j < neighbors.size(); ++j)
        m_needs_plane[neighbors[j]] = true;
    }
  }

  /// Whether no point rests
  bool empty() const { return m_needs_plane.empty(); }

  /// Whether a point moves, or another one looks at its tangent plane
  bool needs_plane(std::size_t i) const { return m_needs_plane.empty() || m_needs_plane[i]; }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FLOW_RESTING_POINTS_H
