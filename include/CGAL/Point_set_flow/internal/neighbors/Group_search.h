// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_GROUP_SEARCH_H
#define CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_GROUP_SEARCH_H

#include <CGAL/Point_set_flow/internal/neighbors/Neighbor_tree.h>

#include <Eigen/Core>

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

/// One thread's search for the `k` nearest neighbors of many points that follow each other in space.
///
/// A few of them at a time have nearly the same neighbors: what is near to their box is collected
/// once, side by side in memory, and the nearest of each point are chosen from that.
class Group_search {
  static constexpr std::size_t group_size = 8;

  const Neighbor_tree& m_tree;
  const std::size_t m_k;
  const double m_largest; // no neighbor is farther than this
  double m_radius = -1.;  // of the neighborhood before; unknown at first

  // what is within m_reach of the box of the group, in the order of the tree
  double m_reach = 0.;
  std::array<double, 3> m_low, m_high;
  std::size_t m_count = 0;
  Eigen::ArrayXd m_x, m_y, m_z, m_squared_distance;
  std::vector<std::uint32_t> m_site;

  // those of them that are near enough to be sure of them
  std::size_t m_within = 0;
  double m_squared_limit = 0.;
  std::vector<std::uint32_t> m_near;
  std::vector<double> m_squared;
  std::vector<Neighbor_tree::Neighbor> m_sorted;
  std::vector<std::uint32_t> m_found;

public:
  /// \param radius the distance beyond which there are no neighbors, 0 for no limit
  Group_search(const Neighbor_tree& tree, std::size_t k, double radius)
      : m_tree(tree), m_k(k),
        m_largest(radius > 0. ? radius : (std::numeric_limits<double>::infinity)())
  {
    make_room(256);
  }

  /// Calls `visit(neighbors, radius)` for each point of `[first, last)`, one after the other: its nearest
  /// neighbors without itself, in an order that depends on the tree only, and the distance of the
  /// farthest.
  template <typename Iterator, typename Visit>
  void operator()(Iterator first, Iterator last, const Visit& visit)
  {
    const Array<Point_3>& points = m_tree.points();
    while (first != last) {
      if (m_radius < 0.)
        m_radius = radius_of(*first);
      // a group ends where the next point is not near: its box is to be small
      Iterator end = first;
      m_low = m_high = coordinates(points[*first]);
      for (std::size_t n = 0; n < group_size && end != last; ++n, ++end)
        if (!grow_box(coordinates(points[*end])))
          break;
      // A ball that holds a crowd is that of a place much less dense than others: there each point
      // does better alone.
      bool enough = collect(1.1 * m_radius, 32 * (m_k + group_size));
      double largest = 0.;
      do {
        enough = enough && choose(*first);
        if (!enough)
          choose_alone(*first);
        visit(m_found, m_radius);
        largest = (std::max)(largest, m_radius);
        ++first;
      } while (enough && first != end);
      // a point far from the others says nothing about those that follow
      m_radius = enough ? largest : -1.;
    }
  }

private:
  static std::array<double, 3> coordinates(const Point_3& p) { return {{p.x(), p.y(), p.z()}}; }

  double radius_of(std::size_t i) const
  {
    Neighbor_tree::Query query(m_tree, m_k); // exact, and slow
    const std::vector<Neighbor_tree::Neighbor>& found = query(i);
    return found.empty() ? 0. : std::sqrt(found.back().squared_distance);
  }

  bool grow_box(const std::array<double, 3>& p)
  {
    std::array<double, 3> low = m_low, high = m_high;
    for (std::size_t d = 0; d < 3; ++d) {
      low[d] = (std::min)(low[d], p[d]);
      high[d] = (std::max)(high[d], p[d]);
      if (high[d] - low[d] > 2. * m_radius)
        return false;
    }
    m_low = low;
    m_high = high;
    return true;
  }

  void make_room(std::size_t size)
  {
    m_x.conservativeResize(Eigen::Index(size));
    m_y.conservativeResize(Eigen::Index(size));
    m_z.conservativeResize(Eigen::Index(size));
    m_squared_distance.resize(Eigen::Index(size));
    m_site.resize(size);
    m_near.resize(size + 1);
    m_squared.resize(size + 1);
  }

  /// Collects all points within a distance from the box.
  /// \return whether they are not more than `most`
  bool collect(double reach, std::size_t most)
  {
    m_reach = (std::min)(reach, m_largest);
    m_count = 0;
    return m_tree.visit_leaves(m_low, m_high, m_reach * m_reach,
                               [&](const std::size_t* begin, const std::size_t* end) {
                                 collect_near(begin, end);
                                 return m_count <= most;
                               });
  }

  void collect_near(const std::size_t* begin, const std::size_t* end)
  {
    const std::size_t size = m_count + std::size_t(end - begin);
    if (size > m_site.size())
      make_room(2 * size);
    double* const xs = m_x.data();
    double* const ys = m_y.data();
    double* const zs = m_z.data();
    std::uint32_t* const sites = m_site.data();
    const Point_3* const points = m_tree.points().data();
    const std::array<double, 3> low = m_low, high = m_high;
    const double squared = m_reach * m_reach;
    std::size_t count = m_count;
    for (; begin != end; ++begin) {
      const Point_3& p = points[*begin];
      const double x = p.x(), y = p.y(), z = p.z();
      xs[count] = x;
      ys[count] = y;
      zs[count] = z;
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

  /// Chooses the nearest of what is collected.
  /// \return whether that is enough
  bool choose(std::size_t i)
  {
    const Point_3& p = m_tree.points()[i];
    const Eigen::Index n = Eigen::Index(m_count);
    m_squared_distance.head(n) = (m_x.head(n) - p.x()).square() + (m_y.head(n) - p.y()).square() +
                                 (m_z.head(n) - p.z()).square();
    // most have as many neighbors in a ball a little larger than that of the point before; nothing
    // farther than m_reach is known
    const double likely = 1.15 * m_radius;
    if (!(likely < m_reach && gather(likely * likely) >= m_k) && gather(m_reach * m_reach) < m_k &&
        m_reach < m_largest && m_count < m_tree.points().size())
      return false;
    keep_nearest(i);
    return true;
  }

  /// Collects what one point needs, and chooses from that.
  void choose_alone(std::size_t i)
  {
    m_low = m_high = coordinates(m_tree.points()[i]);
    m_radius = radius_of(i);
    collect(m_radius * (1. + 1e-12) + (std::numeric_limits<double>::min)(), // rounding
            m_tree.points().size());
    choose(i);
  }

  /// Gathers those that are not farther.
  /// \return how many, without the point itself
  std::size_t gather(double squared_radius)
  {
    const double* const squared = m_squared_distance.data();
    std::uint32_t* const near = m_near.data();
    std::size_t n = 0;
    for (std::size_t j = 0; j < m_count; ++j) {
      near[n] = static_cast<std::uint32_t>(j);
      n += std::size_t(squared[j] <= squared_radius);
    }
    m_squared_limit = squared_radius;
    m_within = n;
    return n - 1;
  }

  /// The `k` nearest of those gathered, in the order in which they were collected
  void keep_nearest(std::size_t i)
  {
    for (std::size_t j = 0; j < m_within; ++j)
      m_squared[j] = m_squared_distance[m_near[j]];
    Neighbor_tree::Neighbor last = {(std::numeric_limits<double>::infinity)(), 0};
    if (m_within > m_k + 1)
      last = farthest_of_nearest();
    m_found.resize(m_within + 1);
    std::size_t count = 0;
    double largest = 0.;
    for (std::size_t j = 0; j < m_within; ++j) {
      const double squared = m_squared[j];
      const std::uint32_t site = m_site[m_near[j]];
      m_found[count] = site;
      const bool is_near = (squared < last.squared_distance) |
                           ((squared == last.squared_distance) & (site <= last.index));
      largest = (std::max)(largest, is_near ? squared : 0.);
      count += std::size_t(is_near & (site != i));
    }
    m_found.resize((std::min)(count, m_k)); // squared distances may be 0 between distinct points
    m_radius = std::sqrt(largest);
  }

  /// What separates the `k` nearest of those gathered from the others. The number of points in a
  /// ball on a surface grows with its squared radius, so that a few interpolations tell.
  Neighbor_tree::Neighbor farthest_of_nearest()
  {
    double low = 0., high = m_squared_limit;
    const std::size_t wanted = m_k + 1; // with the point itself, which is the nearest
    std::size_t below = 0, above = m_within;
    for (int step = 0; step < 8; ++step) {
      const double middle =
          low + (high - low) * (double(wanted - below) + .5) / (double(above - below) + 1.);
      std::size_t count = 0;
      for (std::size_t j = 0; j < m_within; ++j)
        count += std::size_t(m_squared[j] <= middle);
      if (count == wanted)
        return {middle, (std::numeric_limits<std::uint32_t>::max)()};
      if (count < wanted)
        low = middle, below = count;
      else
        high = middle, above = count;
    }
    m_sorted.clear();
    for (std::size_t j = 0; j < m_within; ++j)
      m_sorted.push_back({m_squared[j], m_site[m_near[j]]});
    const auto nth = m_sorted.begin() + std::ptrdiff_t(wanted - 1);
    std::nth_element(m_sorted.begin(), nth, m_sorted.end());
    return *nth;
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_GROUP_SEARCH_H
