// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_GROUP_SEARCH_H
#define CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_GROUP_SEARCH_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/neighbors/Candidates.h>
#include <CGAL/Point_set_flow/internal/neighbors/Neighbor_query.h>
#include <CGAL/Point_set_flow/internal/neighbors/Search_options.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// One thread's search for the nearest neighbors of many points that follow each other in space.
///
/// A few of them at a time have nearly the same neighbors: what is near to their box is collected
/// once, and the nearest of each point are chosen from that.
class Group_search {
  static constexpr std::size_t group_size = 32;

  const Neighbor_tree& m_tree;
  const Search_options& m_options;
  const double m_largest; // no neighbor is farther than this
  std::size_t m_k = 0;    // of the point at hand
  double m_radius = -1.;  // of the neighborhood before; unknown at first
  Candidates m_candidates;
  Eigen::ArrayXd m_squared_distance; // of the candidates

  // those of them that are near enough to be sure of them
  std::size_t m_within = 0;
  double m_squared_limit = 0.;
  std::vector<std::uint32_t> m_near;
  std::vector<double> m_squared;
  std::vector<Neighbor> m_sorted;
  std::vector<std::uint32_t> m_found;

public:
  Group_search(const Neighbor_tree& tree, const Search_options& options)
      : m_tree(tree), m_options(options),
        m_largest(options.radius > 0. ? options.radius : (std::numeric_limits<double>::infinity)()),
        m_candidates(tree)
  {}

  /// Calls `visit(neighbors, radius)` for each point of `[first, last)`, one after the other: its nearest
  /// neighbors without itself, in the order of the points, and the distance of the farthest.
  template <typename Iterator, typename Visit>
  void operator()(Iterator first, Iterator last, const Visit& visit)
  {
    const Array<Point_3>& points = m_tree.points();
    while (first != last) {
      change_k(*first);
      if (m_radius < 0.)
        m_radius = radius_of(*first);
      // a group ends where the next point is not near, to keep its box small
      Iterator end = first;
      m_candidates.start_box(points[*first]);
      for (std::size_t n = 0; n < group_size && end != last; ++n, ++end)
        if (most_neighbors(*end) != m_k || !m_candidates.grow_box(points[*end], 2. * m_radius))
          break;
      // A ball with that many points belongs to a sparse place beside a dense one: there, each point
      // is better searched alone.
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
      // a point far from the others predicts nothing about those that follow
      m_radius = enough ? largest : -1.;
    }
  }

private:
  std::size_t most_neighbors(std::size_t i) const
  {
    return (std::min)(m_options.k_of(i), m_tree.points().size() - 1);
  }

  /// The points of a group have as many neighbors each.
  void change_k(std::size_t i)
  {
    const std::size_t k = most_neighbors(i);
    // the number of points in a ball on a surface grows with its squared radius
    if (m_radius >= 0. && k != m_k)
      m_radius *= std::sqrt(double(k) / double(m_k));
    m_k = k;
  }

  double radius_of(std::size_t i) const
  {
    Neighbor_query query(m_tree, m_k); // exact, and slow
    const std::vector<Neighbor>& found = query(i);
    return found.empty() ? 0. : std::sqrt(found.back().squared_distance);
  }

  bool collect(double reach, std::size_t most)
  {
    const bool enough = m_candidates.collect((std::min)(reach, m_largest), most);
    if (m_near.size() <= m_candidates.capacity()) {
      m_squared_distance.resize(Eigen::Index(m_candidates.capacity()));
      m_near.resize(m_candidates.capacity() + 1);
      m_squared.resize(m_candidates.capacity() + 1);
    }
    return enough;
  }

  /// Chooses the nearest of the candidates.
  /// \return whether these are enough
  bool choose(std::size_t i)
  {
    m_candidates.squared_distances(m_tree.points()[i], m_squared_distance);
    // most have as many neighbors in a ball a little larger than that of the point before; nothing
    // beyond the reach of the candidates is known
    const double likely = 1.15 * m_radius, reach = m_candidates.reach();
    if (!(likely < reach && gather(likely * likely) >= m_k) && gather(reach * reach) < m_k &&
        reach < m_largest) {
      if (m_candidates.size() < m_tree.points().size())
        return false;
      gather(m_largest * m_largest); // all points are candidates
    }
    keep_nearest(i);
    return true;
  }

  /// Collects what one point needs, and chooses from that.
  void choose_alone(std::size_t i)
  {
    m_candidates.start_box(m_tree.points()[i]);
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
    const std::size_t count = m_candidates.size();
    for (std::size_t j = 0; j < count; ++j) {
      near[n] = static_cast<std::uint32_t>(j);
      n += std::size_t(squared[j] <= squared_radius);
    }
    m_squared_limit = squared_radius;
    m_within = n;
    return n - 1;
  }

  /// The `k` nearest of those gathered, in the order of the points
  void keep_nearest(std::size_t i)
  {
    for (std::size_t j = 0; j < m_within; ++j)
      m_squared[j] = m_squared_distance[m_near[j]];
    Neighbor last = {(std::numeric_limits<double>::infinity)(), 0};
    if (m_within > m_k + 1)
      last = farthest_of_nearest();
    m_found.resize(m_within + 1);
    std::size_t count = 0;
    double largest = 0.;
    for (std::size_t j = 0; j < m_within; ++j) {
      const double squared = m_squared[j];
      const std::uint32_t site = m_candidates.site(m_near[j]);
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
  /// ball on a surface grows with its squared radius, so that a few interpolations suffice.
  Neighbor farthest_of_nearest()
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
      m_sorted.push_back({m_squared[j], m_candidates.site(m_near[j])});
    const auto nth = m_sorted.begin() + std::ptrdiff_t(wanted - 1);
    std::nth_element(m_sorted.begin(), nth, m_sorted.end());
    return *nth;
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_GROUP_SEARCH_H
