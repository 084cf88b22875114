// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_CANDIDATES_H
#define CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_CANDIDATES_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/neighbors/Neighbor_tree.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// The points within some distance of a box around a group of points, side by side in memory, in their
/// own order.
class Candidates {
  const Neighbor_tree& m_tree;
  Box_3 m_box = Box_3(Point_3(0., 0., 0.));
  double m_reach = 0.;
  std::size_t m_count = 0;
  Eigen::ArrayXd m_x, m_y, m_z;
  std::vector<std::uint32_t> m_sites;

public:
  explicit Candidates(const Neighbor_tree& tree) : m_tree(tree) { make_room(256); }

  std::size_t size() const { return m_count; }
  /// how many there is room for
  std::size_t capacity() const { return m_sites.size(); }
  /// the distance from the box up to which all points are there
  double reach() const { return m_reach; }
  std::uint32_t site(std::size_t j) const { return m_sites[j]; }

  void start_box(const Point_3& p) { m_box = Box_3(p); }

  /// \return whether the box now holds the point: it does unless a side becomes too long
  bool grow_box(const Point_3& p, double longest_side)
  {
    Box_3 box = m_box;
    box.add(Box_3(p));
    for (std::size_t d = 0; d < 3; ++d)
      if (box.high[d] - box.low[d] > longest_side)
        return false;
    m_box = box;
    return true;
  }

  /// Collects all points within a distance from the box.
  /// \return whether they are not more than `most`
  bool collect(double reach, std::size_t most)
  {
    m_reach = reach;
    m_count = 0;
    return m_tree.visit_leaves(m_box, m_reach * m_reach, [&](std::size_t begin, std::size_t end) {
      collect_near(begin, end);
      return m_count <= most;
    });
  }

  void squared_distances(const Point_3& p, Eigen::ArrayXd& squared) const
  {
    const Eigen::Index n = Eigen::Index(m_count);
    squared.head(n) = (m_x.head(n) - p.x()).square() + (m_y.head(n) - p.y()).square() +
                      (m_z.head(n) - p.z()).square();
  }

private:
  void make_room(std::size_t size)
  {
    m_x.conservativeResize(Eigen::Index(size));
    m_y.conservativeResize(Eigen::Index(size));
    m_z.conservativeResize(Eigen::Index(size));
    m_sites.resize(size);
  }

  void collect_near(std::size_t begin, std::size_t end)
  {
    const std::size_t size = m_count + (end - begin);
    if (size > capacity())
      make_room(2 * size);
    const Point_3* const points = m_tree.points().data();
    const Box_3 box = m_box;
    const double squared = m_reach * m_reach;
    std::size_t count = m_count;
    for (std::size_t i = begin; i != end; ++i) {
      m_sites[count] = static_cast<std::uint32_t>(i);
      m_x[Eigen::Index(count)] = points[i].x();
      m_y[Eigen::Index(count)] = points[i].y();
      m_z[Eigen::Index(count)] = points[i].z();
      count += std::size_t(box.squared_distance(Box_3(points[i])) <= squared);
    }
    m_count = count;
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_CANDIDATES_H
