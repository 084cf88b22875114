// SPDX-License-Identifier: GPL-3.0-or-later
#include "Page_tree.h"

#include <limits>
#include <utility>

namespace balanced_flow_blocks {

Page_tree::Page_tree(const std::vector<Page>& pages)
{
  while (m_leaves < pages.size())
    m_leaves *= 2;
  m_nodes.resize(2 * m_leaves);
  for (std::size_t i = 0; i < pages.size(); ++i)
    m_nodes[m_leaves + i] = {pages[i].box, true};
  for (std::size_t node = m_leaves - 1; node > 0; --node)
    for (const std::size_t child : {2 * node, 2 * node + 1})
      if (m_nodes[child].has_unread) {
        m_nodes[node].box.add(m_nodes[child].box);
        m_nodes[node].has_unread = true;
      }
}

void Page_tree::set_read(std::size_t page)
{
  std::size_t node = m_leaves + page;
  m_nodes[node].has_unread = false;
  for (node /= 2; node > 0; node /= 2) {
    Node& parent = m_nodes[node];
    parent = Node();
    for (const std::size_t child : {2 * node, 2 * node + 1})
      if (m_nodes[child].has_unread) {
        parent.box.add(m_nodes[child].box);
        parent.has_unread = true;
      }
  }
}

double Page_tree::distance_to_unread(const std::array<double, 3>& p) const
{
  double nearest = (std::numeric_limits<double>::infinity)();
  if (m_nodes[1].has_unread)
    find_nearest(1, p, nearest);
  return nearest;
}

void Page_tree::find_nearest(std::size_t node, const std::array<double, 3>& p,
                             double& nearest) const
{
  if (node >= m_leaves) {
    nearest = m_nodes[node].box.distance(p);
    return;
  }
  std::size_t first = 2 * node, second = first + 1;
  const auto distance = [&](std::size_t child) {
    return m_nodes[child].has_unread ? m_nodes[child].box.distance(p)
                                     : (std::numeric_limits<double>::infinity)();
  };
  double to_first = distance(first), to_second = distance(second);
  if (to_second < to_first) {
    std::swap(first, second);
    std::swap(to_first, to_second);
  }
  if (to_first < nearest)
    find_nearest(first, p, nearest);
  if (to_second < nearest)
    find_nearest(second, p, nearest);
}

} // namespace balanced_flow_blocks
