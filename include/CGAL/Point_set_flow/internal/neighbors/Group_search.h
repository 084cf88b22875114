// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_GROUP_SEARCH_H
#define CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_GROUP_SEARCH_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/neighbors/Candidates.h>
#include <CGAL/Point_set_flow/internal/neighbors/Nearest_first.h>
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

  std::vector<Neighbor> m_near; // those of them that are near enough to be sure of them
  Nearest_first m_nearest_first;
  std::vector<Neighbor> m_found;

public:
  Group_search(const Neighbor_tree& tree, const Search_options& options)
      : m_tree(tree), m_options(options),
        m_largest(options.radius > 0. ? options.radius : (std::numeric_limits<double>::infinity)()),
        m_candidates(tree)
  {}

  /// Calls `visit(neighbors)` for each point of `[first, last)`, one after the other: its nearest neighbors
  /// without itself, nearest first.
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
      bool enough = collect(1.1 * m_radius);
      double largest = 0.;
      do {
        enough =
            enough && (choose(*first) || (collect(1.5 * m_candidates.reach()) && choose(*first)));
        if (!enough)
          choose_alone(*first);
        visit(m_found);
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
    return m_options.k_of(i, m_tree.points().size());
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

  /// \return whether they are not too many: a ball with that many points belongs to a sparse place beside a
  /// dense one, where each point is better searched alone
  bool collect(double reach) { return collect(reach, 32 * (m_k + group_size)); }

  bool collect(double reach, std::size_t most)
  {
    const bool enough = m_candidates.collect((std::min)(reach, m_largest), most);
    if (m_near.size() <= m_candidates.capacity()) {
      m_squared_distance.resize(Eigen::Index(m_candidates.capacity()));
      m_near.resize(m_candidates.capacity() + 1);
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
    double limit = 1.15 * m_radius;
    const double reach = m_candidates.reach();
    std::size_t within = limit < reach ? gather(limit) : 0;
    if (within <= m_k) {
      limit = reach;
      within = gather(limit);
    }
    if (within <= m_k && reach < m_largest) {
      if (m_candidates.size() < m_tree.points().size())
        return false;
      limit = m_largest;
      within = gather(limit); // all points are candidates
    }
    keep_nearest(i, within, limit * limit);
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
  /// \return how many, with the point itself
  std::size_t gather(double radius)
  {
    const double squared_radius = radius * radius;
    const double* const squared = m_squared_distance.data();
    Neighbor* near = m_near.data();
    for (std::size_t j = 0; j < m_candidates.size(); ++j) {
      *near = {squared[j], m_candidates.site(j)};
      near += std::size_t(squared[j] <= squared_radius);
    }
    return std::size_t(near - m_near.data());
  }

  /// The `k` nearest of those gathered
  void keep_nearest(std::size_t i, std::size_t within, double squared_limit)
  {
    m_nearest_first(m_near.data(), within, m_k + 1, squared_limit, m_found);
    const auto self = std::find_if(m_found.begin(), m_found.end(),
                                   [&](const Neighbor& found) { return found.index == i; });
    if (self != m_found.end())
      m_found.erase(self);                           // as a rule the first one
    m_found.resize((std::min)(m_found.size(), m_k)); // others may be in the same place
    m_radius = m_found.empty() ? 0. : std::sqrt(m_found.back().squared_distance);
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_GROUP_SEARCH_H
