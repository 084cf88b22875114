// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_NEIGHBOR_GRAPH_H
#define CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_NEIGHBOR_GRAPH_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/Neighborhood_3.h>
#include <CGAL/Point_set_flow/internal/neighbors/Group_search.h>
#include <CGAL/Point_set_flow/internal/neighbors/Neighbor_chunk.h>
#include <CGAL/Point_set_flow/internal/neighbors/Search_options.h>
#include <CGAL/Point_set_flow/internal/parallel/Array.h>
#include <CGAL/Point_set_flow/internal/parallel/Loops.h>

#include <boost/config.hpp>
#include <boost/iterator/counting_iterator.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// The nearest neighbors of points, nearest first: the first of them are the neighbors in a smaller neighborhood.
class Neighbor_graph {
  std::vector<Neighbor_chunk> m_chunks;
  Array<Compact_length> m_radii; // the distance of the farthest neighbor

public:
  /// A graph without points
  Neighbor_graph() = default;

  /// \param most tells how many neighbors point `i` has, or more: memory for them is taken at once
  /// \param fill_chunk called for each chunk as `fill_chunk(begin, end, add)`, calls
  /// `add(i, site, size, number, radius)` for those of its points that have neighbors; see `Neighbor_chunk::add()`
  template <typename Most, typename Fill_chunk, typename ConcurrencyTag>
  Neighbor_graph(std::size_t n, const Most& most, const Fill_chunk& fill_chunk,
                 Loops<ConcurrencyTag>& loops)
      : m_chunks((n + chunk_size - 1) / chunk_size), m_radii(n, Compact_length())
  {
    loops.for_each_chunk(
        n, [&](std::size_t begin, std::size_t end) { fill(begin, end, most, fill_chunk); });
  }

  /// \param sites, n points of the tree, which follow each other in space
  template <typename Iterator, typename ConcurrencyTag>
  Neighbor_graph(const Neighbor_tree& tree, Iterator sites, std::size_t n,
                 const Search_options& search, Loops<ConcurrencyTag>& loops)
      : Neighbor_graph(
            n,
            [&](std::size_t i) {
              return search.k_of(sites[std::ptrdiff_t(i)], tree.points().size());
            },
            [&](std::size_t begin, std::size_t end, const auto& add) {
              Group_search find(tree, search);
              find_neighbors(find, tree.points(), sites, begin, end, add);
            },
            loops)
  {}

  /// Of all points
  template <typename ConcurrencyTag>
  Neighbor_graph(const Neighbor_tree& tree, const Search_options& search,
                 Loops<ConcurrencyTag>& loops)
      : Neighbor_graph(tree, Site(0), tree.points().size(), search, loops)
  {}

  std::size_t number_of_points() const { return m_radii.size(); }
  std::size_t size(std::size_t i) const { return neighbors(i).size(); }
  double radius(std::size_t i) const { return m_radii[i].value(); }
  const Compact_length* radii() const { return m_radii.data(); }
  Neighbor_numbers neighbors(std::size_t i) const { return neighbors(i, i); }
  /// \param site the number of point `i` in the tree
  Neighbor_numbers neighbors(std::size_t i, std::size_t site) const
  {
    return m_chunks[i / chunk_size].neighbors(i % chunk_size, site);
  }

  /// \param points where the points are now
  /// \param filter_width the width of the Gaussian in multiples of the neighborhood radius
  Neighborhood_3 neighborhood(const Array<Point_3>& points, std::size_t i,
                              double filter_width) const
  {
    return Neighborhood_3(points.data(), i, neighbors(i), radius(i), filter_width);
  }

  /// Whether a point is far from all others: its neighborhood is several times as large as each of its
  /// neighbors'. A scanner's invalid points are, which are written in one place.
  bool is_isolated(std::size_t i) const
  {
    const double several = 4., limit = radius(i) / several;
    const Neighbor_numbers around = neighbors(i);
    for (std::size_t j = 0; j < around.size(); ++j)
      if (radius(around[j]) >= limit)
        return false; // as a rule, the first one
    return true;
  }

  Array<Compact_length>&& take_radii() { return std::move(m_radii); }

  /// Leaves each point the nearest of its neighbors.
  /// \param points where the points were when the graph was made
  /// \param sizes how many, for each point; 0, or more than there are, is as many as there are
  template <typename ConcurrencyTag>
  void shrink(const Array<Point_3>& points, const Array<std::uint32_t>& sizes,
              Loops<ConcurrencyTag>& loops)
  {
    loops.for_each_chunk(number_of_points(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        if (sizes[i] != 0)
          shrink(points, i, sizes[i]);
    });
  }

  /// Gives each point the neighbors that a search would find, and searches only where those at hand are too few.
  template <typename ConcurrencyTag>
  void adapt(const Neighbor_tree& tree, const Search_options& search, Loops<ConcurrencyTag>& loops)
  {
    loops.for_each_chunk(number_of_points(), [&](std::size_t begin, std::size_t end) {
      std::size_t next = begin;
      while (next < end && is_enough(next, search))
        ++next;
      if (next < end)
        search_again(tree, search, begin, end);
      else
        for (std::size_t i = begin; i < end; ++i)
          shrink(tree.points(), i, search.k_of(i));
    });
  }

private:
  typedef boost::counting_iterator<std::size_t> Site;

  /// Fills a chunk anew. What it holds can be used meanwhile.
  template <typename Most, typename Fill_chunk>
  void fill(std::size_t begin, std::size_t end, const Most& most, const Fill_chunk& fill_chunk)
  {
    std::size_t neighbors = 0;
    for (std::size_t i = begin; i < end; ++i)
      neighbors += most(i);
    Neighbor_chunk chunk;
    chunk.reserve(end - begin, neighbors);
    fill_chunk(
        begin, end,
        [&](std::size_t i, std::size_t site, std::size_t size, const auto& number, double radius) {
          chunk.add(i - begin, site, size, number);
          m_radii[i] = Compact_length(radius);
        });
    chunk.skip(end - begin);
    m_chunks[begin / chunk_size] = Neighbor_chunk();      // memory
    m_chunks[begin / chunk_size] = Neighbor_chunk(chunk); // a copy takes no more than it needs
  }

  /// Not inlined: a compiler that fuses multiplication and addition may do so in one place and not in another, and
  /// radii must not depend on whether they were found by a search or by shrinking.
  BOOST_NOINLINE static double distance(const Point_3& p, const Point_3& q)
  {
    return std::sqrt(squared_distance(p, q));
  }

  bool is_enough(std::size_t i, const Search_options& search) const
  {
    return search.k_of(i, number_of_points()) <= size(i);
  }

  /// Searches the neighbors of those points of a chunk that have too few.
  void search_again(const Neighbor_tree& tree, const Search_options& search, std::size_t begin,
                    std::size_t end)
  {
    fill(
        begin, end, [&](std::size_t i) { return search.k_of(i, number_of_points()); },
        [&](std::size_t, std::size_t, const auto& add) {
          Group_search find(tree, search);
          for (std::size_t i = begin; i < end;) {
            std::size_t next = i;
            for (; next < end && is_enough(next, search); ++next) {
              const Neighbor_numbers all = neighbors(next);
              const std::size_t count = (std::min)(search.k_of(next), all.size());
              add(
                  next, next, count, [&](std::size_t j) { return all[j]; },
                  radius(tree.points(), next, count));
            }
            i = next;
            while (next < end && !is_enough(next, search))
              ++next;
            find_neighbors(find, tree.points(), Site(0), i, next, add);
            i = next;
          }
        });
  }

  /// The distance of the farthest of the nearest neighbors of a point
  double radius(const Array<Point_3>& points, std::size_t i, std::size_t count) const
  {
    const Neighbor_numbers all = neighbors(i);
    return count == all.size() || count == 0 ? radius(i)
                                             : distance(points[i], points[all[count - 1]]);
  }

  void shrink(const Array<Point_3>& points, std::size_t i, std::size_t most)
  {
    const std::size_t count = (std::min)(most, size(i));
    m_radii[i] = Compact_length(radius(points, i, count));
    m_chunks[i / chunk_size].shrink(i % chunk_size, count);
  }

  template <typename Iterator, typename Add>
  static void find_neighbors(Group_search& find, const Array<Point_3>& points, Iterator sites,
                             std::size_t begin, std::size_t end, const Add& add)
  {
    std::size_t i = begin;
    find(sites + std::ptrdiff_t(begin), sites + std::ptrdiff_t(end),
         [&](const std::vector<Neighbor>& found) {
           const std::size_t site = sites[std::ptrdiff_t(i)];
           add(
               i, site, found.size(), [&](std::size_t j) { return found[j].index; },
               found.empty() ? 0. : distance(points[site], points[found.back().index]));
           ++i;
         });
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_NEIGHBOR_GRAPH_H
