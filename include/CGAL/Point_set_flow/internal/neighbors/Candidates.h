// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_CANDIDATES_H
#define CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_CANDIDATES_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/neighbors/Neighbor_tree.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// The points within some distance of a box around a group of points, side by side in memory, in their
/// own order: sums over neighbors must not depend on how a tree splits, which points far away decide.
class Candidates {
  const Neighbor_tree& m_tree;
  std::array<double, 3> m_low, m_high;
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

  void start_box(const Point_3& p) { m_low = m_high = {{p.x(), p.y(), p.z()}}; }

  /// \return whether the box now holds the point: it does unless a side becomes too long
  bool grow_box(const Point_3& p, double longest_side)
  {
    std::array<double, 3> low = m_low, high = m_high;
    for (std::size_t d = 0; d < 3; ++d) {
      low[d] = (std::min)(low[d], p[int(d)]);
      high[d] = (std::max)(high[d], p[int(d)]);
      if (high[d] - low[d] > longest_side)
        return false;
    }
    m_low = low;
    m_high = high;
    return true;
  }

  /// Collects all points within a distance from the box.
  /// \return whether they are not more than `most`
  bool collect(double reach, std::size_t most)
  {
    m_reach = reach;
    m_count = 0;
    const bool is_all = m_tree.visit_leaves(m_low, m_high, m_reach * m_reach,
                                            [&](const std::size_t* begin, const std::size_t* end) {
                                              collect_near(begin, end);
                                              return m_count <= most;
                                            });
    if (is_all)
      put_in_order();
    return is_all;
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

  void put_in_order()
  {
    std::sort(m_sites.begin(), m_sites.begin() + std::ptrdiff_t(m_count));
    for (std::size_t j = 0; j < m_count; ++j) {
      const Point_3& p = m_tree.points()[m_sites[j]];
      m_x[Eigen::Index(j)] = p.x();
      m_y[Eigen::Index(j)] = p.y();
      m_z[Eigen::Index(j)] = p.z();
    }
  }

  void collect_near(const std::size_t* begin, const std::size_t* end)
  {
    const std::size_t size = m_count + std::size_t(end - begin);
    if (size > capacity())
      make_room(2 * size);
    std::uint32_t* const sites = m_sites.data();
    const Point_3* const points = m_tree.points().data();
    const std::array<double, 3> low = m_low, high = m_high;
    const double squared = m_reach * m_reach;
    std::size_t count = m_count;
    for (; begin != end; ++begin) {
      const Point_3& p = points[*begin];
      const double x = p.x(), y = p.y(), z = p.z();
      sites[count] = static_cast<std::uint32_t>(*begin);
      const auto clamp = [](double c, double least, double most) {
        const double lower = c < least ? least : c;
        return c - (lower > most ? most : lower);
      };
      const double dx = clamp(x, low[0], high[0]), dy = clamp(y, low[1], high[1]),
                   dz = clamp(z, low[2], high[2]);
      count += std::size_t(dx * dx + dy * dy + dz * dz <= squared);
    }
    m_count = count;
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_CANDIDATES_H
