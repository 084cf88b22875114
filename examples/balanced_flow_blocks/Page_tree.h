// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_BLOCKS_PAGE_TREE_H
#define BALANCED_FLOW_BLOCKS_PAGE_TREE_H

#include "Page.h"

#include <cstddef>
#include <vector>

namespace balanced_flow_blocks {

/// Which pages were read, and where the others are
class Page_tree {
  struct Node {
    Box box;
    bool has_unread = false;
  };
  std::size_t m_leaves = 1;  // a power of 2; page i is node m_leaves + i
  std::vector<Node> m_nodes; // the children of node i are 2 i and 2 i + 1

public:
  explicit Page_tree(const std::vector<Page>& pages);

  bool is_read(std::size_t page) const { return !m_nodes[m_leaves + page].has_unread; }
  void set_read(std::size_t page);

  /// The distance to the nearest box of a page that was not read; infinite if all were
  double distance_to_unread(const std::array<double, 3>& p) const;

  /// Calls `visit(page)` for each page that was not read and is within a distance.
  template <typename Place, typename Visit>
  void for_each_unread(const Place& place, double distance, const Visit& visit) const
  {
    for_each_unread(1, place, distance, visit);
  }

private:
  void find_nearest(std::size_t node, const std::array<double, 3>& p, double& nearest) const;

  template <typename Place, typename Visit>
  void for_each_unread(std::size_t node, const Place& place, double distance,
                       const Visit& visit) const
  {
    if (!m_nodes[node].has_unread || !(m_nodes[node].box.distance(place) <= distance))
      return;
    if (node >= m_leaves)
      return visit(node - m_leaves);
    for_each_unread(2 * node, place, distance, visit);
    for_each_unread(2 * node + 1, place, distance, visit);
  }
};

} // namespace balanced_flow_blocks

#endif // BALANCED_FLOW_BLOCKS_PAGE_TREE_H
