// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_NEIGHBOR_QUERY_H
#define CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_NEIGHBOR_QUERY_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/neighbors/Neighbor.h>
#include <CGAL/Point_set_flow/internal/neighbors/Neighbor_tree.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// One thread's search for the `k` nearest neighbors of single query points. It keeps its result in one
/// sorted buffer and starts from what the query before it found, which makes it several times faster
/// than `Orthogonal_k_neighbor_search` for points in spatial order. Of neighbors at the same distance
/// the order of the points decides; \cgal's searches leave that to their traversal of the tree.
class Neighbor_query {
  const Neighbor_tree& m_tree;
  std::size_t m_k;
  double m_largest; // no neighbor is farther than this squared distance
  double m_bound = 0.;
  static constexpr std::size_t nowhere = std::size_t(-1);
  std::size_t m_center = 0; // is not its own neighbor
  Point_3 m_before = Point_3(0., 0., 0.);
  Box_3 m_query = Box_3(Point_3(0., 0., 0.));
  std::vector<Neighbor> m_found;

public:
  /// \param radius the distance beyond which there are no neighbors, 0 for no limit
  Neighbor_query(const Neighbor_tree& tree, std::size_t k, double radius = 0.)
      : m_tree(tree), m_k(k),
        m_largest(radius > 0. ? radius * radius : (std::numeric_limits<double>::infinity)())
  {
    m_found.reserve(k + 1);
  }

  /// The nearest neighbors of point `i`, without itself, nearest first.
  const std::vector<Neighbor>& operator()(std::size_t i)
  {
    if (m_center == nowhere)
      m_found.clear(); // point i may be among them
    m_center = i;
    return search(m_tree.points()[i]);
  }

  /// The nearest points of any place, nearest first.
  const std::vector<Neighbor>& operator()(const Point_3& place)
  {
    m_center = nowhere;
    return search(place);
  }

private:
  const std::vector<Neighbor>& search(const Point_3& p)
  {
    m_bound = m_largest;
    if (m_found.size() == m_k && m_k != 0) {
      // the ball of the previous answer holds k points other than this one (its own center
      // instead, if this one was among them): so does, around this point, a ball larger by the
      // distance of the two
      const double moved = std::sqrt(squared_distance(p, m_before));
      const double radius = std::sqrt(m_found.back().squared_distance) + moved;
      m_bound = (std::min)(m_bound, radius * radius * (1. + 1e-12) +
                                        (std::numeric_limits<double>::min)()); // rounding
    }
    m_found.clear();
    m_before = p;
    m_query = Box_3(p);
    if (!m_tree.nodes().empty())
      visit(0);
    return m_found;
  }

  double squared_distance_of(std::size_t node) const
  {
    return m_tree.nodes()[node].box.squared_distance(m_query);
  }

  /// Visits what is in a node, nearest first.
  void visit(std::size_t n)
  {
    if (m_tree.is_leaf(n)) {
      for (std::size_t i = m_tree.nodes()[n].begin; i < m_tree.nodes()[n].end; ++i)
        offer(i);
      return;
    }
    std::size_t near = n + 1, far = m_tree.nodes()[near].next;
    double to_near = squared_distance_of(near), to_far = squared_distance_of(far);
    if (to_far < to_near) {
      std::swap(near, far);
      std::swap(to_near, to_far);
    }
    if (to_near <= m_bound)
      visit(near);
    if (to_far <= m_bound)
      visit(far);
  }

  void offer(std::size_t i)
  {
    const Neighbor candidate = {squared_distance(m_before, m_tree.points()[i]),
                                static_cast<std::uint32_t>(i)};
    if (!(candidate.squared_distance <= m_bound) || i == m_center)
      return;
    if (m_found.size() == m_k && m_k != 0) {
      if (!(candidate < m_found.back()))
        return;
      m_found.pop_back();
    }
    m_found.insert(std::upper_bound(m_found.begin(), m_found.end(), candidate), candidate);
    if (m_found.size() == m_k)
      m_bound = m_found.back().squared_distance;
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_NEIGHBOR_QUERY_H
