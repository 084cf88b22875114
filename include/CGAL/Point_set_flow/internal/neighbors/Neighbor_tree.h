// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_NEIGHBOR_TREE_H
#define CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_NEIGHBOR_TREE_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/Core_kernel.h>
#include <CGAL/Point_set_flow/internal/order/Morton_curve.h>
#include <CGAL/Point_set_flow/internal/parallel/Array.h>
#include <CGAL/Point_set_flow/internal/parallel/Progress.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// An axis-parallel box
struct Box_3 {
  std::array<double, 3> low, high;

  explicit Box_3(const Point_3& p) : low{{p.x(), p.y(), p.z()}}, high(low) {}

  void add(const Box_3& other)
  {
    for (std::size_t d = 0; d < 3; ++d) {
      low[d] = (std::min)(low[d], other.low[d]);
      high[d] = (std::max)(high[d], other.high[d]);
    }
  }

  /// The squared distance of two boxes. Rounding can not make it larger than that of points in them, since the
  /// sum is taken in the order of `squared_distance()`.
  double squared_distance(const Box_3& other) const
  {
    const auto gap = [&](std::size_t d) {
      const double below = low[d] - other.high[d], above = other.low[d] - high[d];
      const double between = below > above ? below : above; // without branches
      return between > 0. ? between : 0.;
    };
    const double x = gap(0), y = gap(1), z = gap(2);
    return x * x + y * y + z * z;
  }
};

/// A tree of boxes over points in spatial order. Its nodes are cells of the Morton curve: the points in each
/// follow each other, so that there is nothing to sort, and searches come across points in their order.
/// `Neighbor_query` and `Group_search` search it.
class Neighbor_tree {
  static constexpr std::size_t leaf_size = 32;

public:
  /// Points that follow each other, and what comes after them
  struct Node {
    Box_3 box;
    std::uint32_t begin, end;
    std::uint32_t next; ///< the node after all nodes that are part of this one
  };

private:
  const Array<Point_3>& m_points;
  std::vector<Node>
      m_nodes; // each before the nodes that are part of it, and these in the order of the points

public:
  /// \param points in the order of the curve, or searching is slow
  Neighbor_tree(const Array<Point_3>& points, const Progress& progress) : m_points(points)
  {
    m_nodes.reserve(points.size() / 8 + 1); // about as many as there are on surfaces
    if (!points.empty())
      add_node(0, points.size(), progress);
  }

  Neighbor_tree(const Neighbor_tree&) = delete;
  Neighbor_tree& operator=(const Neighbor_tree&) = delete;

  const Array<Point_3>& points() const { return m_points; }
  /// The first one is the root.
  const std::vector<Node>& nodes() const { return m_nodes; }
  bool is_leaf(std::size_t node) const { return m_nodes[node].next == node + 1; }

  /// Calls `visit(begin, end)` for each leaf that may have points within a distance of a box, in the order
  /// of the points, until it returns `false`.
  /// \return whether it never did
  template <typename Visit>
  bool visit_leaves(const Box_3& center, double squared_distance, const Visit& visit) const
  {
    for (std::size_t n = 0; n < m_nodes.size();) {
      const Node& node = m_nodes[n];
      if (!(node.box.squared_distance(center) <= squared_distance)) {
        n = node.next;
        continue;
      }
      if (is_leaf(n) && !visit(std::size_t(node.begin), std::size_t(node.end)))
        return false;
      ++n;
    }
    return true;
  }

private:
  void add_node(std::size_t begin, std::size_t end, const Progress& progress)
  {
    const std::size_t n = m_nodes.size(), worth_asking = 1 << 14;
    m_nodes.push_back({Box_3(m_points[begin]), static_cast<std::uint32_t>(begin),
                       static_cast<std::uint32_t>(end), 0});
    if (end - begin <= leaf_size)
      for (std::size_t i = begin + 1; i < end; ++i)
        m_nodes[n].box.add(Box_3(m_points[i]));
    else {
      if (end - begin > worth_asking)
        progress.ask();
      const std::size_t middle = split(begin, end);
      add_node(begin, middle, progress);
      const std::size_t upper = m_nodes.size();
      add_node(middle, end, progress);
      m_nodes[n].box = m_nodes[n + 1].box;
      m_nodes[n].box.add(m_nodes[upper].box);
    }
    m_nodes[n].next = static_cast<std::uint32_t>(m_nodes.size());
  }

  /// Where the points of a cell cross from one half of it to the other
  std::size_t split(std::size_t begin, std::size_t end) const
  {
    const Point_3& first = m_points[begin];
    const int whole = morton_difference(first, m_points[end - 1]);
    if (whole < 0) // all in one place
      return begin + (end - begin) / 2;
    const auto crossing = std::partition_point(
        m_points.begin() + std::ptrdiff_t(begin + 1), m_points.begin() + std::ptrdiff_t(end - 1),
        [&](const Point_3& p) { return morton_difference(first, p) < whole; });
    return std::size_t(crossing - m_points.begin());
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_NEIGHBOR_TREE_H
