// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_NEIGHBOR_QUERY_H
#define CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_NEIGHBOR_QUERY_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/neighbors/Neighbor_tree.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

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
  std::array<double, 3> m_query = {{0., 0., 0.}};
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
    m_query = {{p.x(), p.y(), p.z()}};
    visit(m_tree.root(), {{0., 0., 0.}});
    return m_found;
  }

  /// \param offset the distance from the query to the box of the node in each coordinate
  void visit(Neighbor_tree::Node node, const std::array<double, 3>& offset)
  {
    if (node->is_leaf()) {
      const auto leaf = static_cast<Neighbor_tree::Leaf>(node);
      for (auto it = leaf->begin(); it != leaf->end(); ++it)
        offer(*it);
      return;
    }
    const auto inner = static_cast<Neighbor_tree::Internal>(node);
    const std::size_t d = std::size_t(inner->cutting_dimension());
    const double below = m_query[d] - inner->lower_high_value();
    const double above = inner->upper_low_value() - m_query[d];
    const bool lower_first = above >= below;
    visit(lower_first ? inner->lower() : inner->upper(), offset);

    std::array<double, 3> far = offset;
    far[d] = (std::max)(far[d], lower_first ? above : below);
    // the sum in the order of squared_distance(): rounding can not make a box farther than the
    // points in it
    if (far[0] * far[0] + far[1] * far[1] + far[2] * far[2] <= m_bound)
      visit(lower_first ? inner->upper() : inner->lower(), far);
  }

  void offer(std::size_t i)
  {
    const Point_3& p = m_tree.points()[i];
    const double x = m_query[0] - p.x(), y = m_query[1] - p.y(), z = m_query[2] - p.z();
    const Neighbor candidate = {x * x + y * y + z * z, static_cast<std::uint32_t>(i)};
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
