// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_NEIGHBOR_GRAPH_H
#define CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_NEIGHBOR_GRAPH_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/Neighborhood_3.h>
#include <CGAL/Point_set_flow/internal/neighbors/Group_search.h>
#include <CGAL/Point_set_flow/internal/neighbors/Search_options.h>
#include <CGAL/Point_set_flow/internal/parallel/Array.h>
#include <CGAL/Point_set_flow/internal/parallel/Loops.h>

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

/// Where the neighbors of each point begin. There may be more than \f$2^{32}\f$ of them, but not of
/// a few points.
class Neighbor_offsets {
  static constexpr std::size_t few = 64;
  Array<std::size_t> m_bases; // of the first of a few points
  Array<std::uint32_t> m_beyond_base;

public:
  void reserve(std::size_t n)
  {
    m_bases.reserve(n / few + 1);
    m_beyond_base.reserve(n);
  }
  void push_back(std::size_t offset)
  {
    if (m_beyond_base.size() % few == 0)
      m_bases.push_back(offset);
    m_beyond_base.push_back(static_cast<std::uint32_t>(offset - m_bases.back()));
  }
  std::size_t operator[](std::size_t i) const { return m_bases[i / few] + m_beyond_base[i]; }
};

/// The nearest neighbors of all points, in one flat array.
class Neighbor_graph {
  Array<std::uint32_t> m_neighbors;
  Neighbor_offsets m_offsets;   // where those of each point begin
  Array<std::uint32_t> m_sizes; // how many of them count
  Array<double> m_radii;        // the distance of the farthest neighbor

public:
  /// A graph without points yet
  Neighbor_graph() = default;

  template <typename ConcurrencyTag>
  Neighbor_graph(const Neighbor_tree& tree, const Search_options& search,
                 Loops<ConcurrencyTag>& loops)
  {
    typedef boost::counting_iterator<std::size_t> Site;
    add(tree, Site(0), Site(tree.points().size()), search, loops);
  }

  /// Adds points of the tree, which follow each other in space, with their neighbors.
  template <typename ConcurrencyTag, typename Iterator>
  void add(const Neighbor_tree& tree, Iterator first, Iterator last, const Search_options& search,
           Loops<ConcurrencyTag>& loops)
  {
    const std::size_t before = m_radii.size(), count = std::size_t(last - first);
    const std::size_t others = tree.points().empty() ? 0 : tree.points().size() - 1;
    m_sizes.resize(before + count, 0);
    m_radii.resize(before + count, 0.);
    std::size_t total = m_neighbors.size();
    m_offsets.reserve(before + count);
    for (std::size_t i = 0; i < count; ++i) {
      m_offsets.push_back(total);
      total += (std::min)(search.k_of(first[std::ptrdiff_t(i)]), others);
    }
    m_neighbors.resize(total);
    loops.for_each_chunk(others == 0 ? 0 : count, [&](std::size_t begin, std::size_t end) {
      Group_search find(tree, search);
      std::size_t i = before + begin;
      find(first + std::ptrdiff_t(begin), first + std::ptrdiff_t(end),
           [&](const std::vector<std::uint32_t>& found, double farthest) {
             std::copy(found.begin(), found.end(),
                       m_neighbors.begin() + std::ptrdiff_t(m_offsets[i]));
             m_sizes[i] = static_cast<std::uint32_t>(found.size());
             m_radii[i] = farthest;
             ++i;
           });
    });
  }

  /// The same graph where point `i` was `numbers[i]`, and is `place[numbers[i]]`. It has as many
  /// points as there are numbers; those that were not in the graph have no neighbors.
  Neighbor_graph renumbered(const std::vector<std::uint32_t>& numbers,
                            const std::vector<std::uint32_t>& place) const
  {
    Neighbor_graph graph;
    graph.m_sizes.assign(numbers.size(), 0);
    graph.m_radii.assign(numbers.size(), 0.);
    for (std::size_t i = 0; i < m_radii.size(); ++i) {
      graph.m_sizes[place[numbers[i]]] = m_sizes[i];
      graph.m_radii[place[numbers[i]]] = m_radii[i];
    }
    std::size_t total = 0;
    graph.m_offsets.reserve(numbers.size());
    for (const std::uint32_t size : graph.m_sizes) {
      graph.m_offsets.push_back(total);
      total += size;
    }
    graph.m_neighbors.resize(total);
    for (std::size_t i = 0; i < m_radii.size(); ++i) {
      std::uint32_t* const first = graph.m_neighbors.data() + graph.m_offsets[place[numbers[i]]];
      for (std::size_t j = 0; j < m_sizes[i]; ++j)
        first[j] = place[neighbors(i)[j]];
    }
    return graph;
  }

  /// \param points where the points are now
  /// \param filter_width the width of the Gaussian in multiples of the neighborhood radius
  /// \param surface what else is known of the surface around point `i`
  Neighborhood_3 neighborhood(const Array<Point_3>& points, std::size_t i, double filter_width,
                              const Surface_estimate_3& surface = Surface_estimate_3()) const
  {
    return Neighborhood_3(points.data(), i, neighbors(i), size(i), m_radii[i], filter_width,
                          surface);
  }

  std::size_t size(std::size_t i) const { return m_sizes[i]; }
  const std::uint32_t* neighbors(std::size_t i) const { return m_neighbors.data() + m_offsets[i]; }
  double radius(std::size_t i) const { return m_radii[i]; }

  /// Whether a point is far from all others: its neighborhood is several times as large as each of its
  /// neighbors'. A scanner's invalid points are, which are written in one place.
  bool is_isolated(std::size_t i) const
  {
    const double several = 4., limit = m_radii[i] / several;
    for (std::size_t j = 0; j < m_sizes[i]; ++j)
      if (m_radii[neighbors(i)[j]] >= limit)
        return false; // as a rule, the first one
    return true;
  }

  Array<double>&& take_radii() { return std::move(m_radii); }

  /// Leaves each point the nearest of its neighbors.
  /// \param points where the points were when the graph was made
  /// \param sizes how many, for each point; more than there are is as many as there are
  template <typename ConcurrencyTag>
  void shrink(const Array<Point_3>& points, const Array<std::uint32_t>& sizes,
              Loops<ConcurrencyTag>& loops)
  {
    const auto shrink_chunk = [&](std::size_t begin, std::size_t end) {
      std::vector<Neighbor> nearest;
      for (std::size_t i = begin; i < end; ++i) {
        if (sizes[i] >= m_sizes[i] || sizes[i] == 0)
          continue;
        std::uint32_t* const first = m_neighbors.data() + m_offsets[i];
        std::uint32_t* const last = first + m_sizes[i];
        nearest.clear();
        for (const std::uint32_t* j = first; j != last; ++j)
          nearest.push_back({squared_distance(points[i], points[*j]), *j});
        const auto nth = nearest.begin() + (sizes[i] - 1);
        std::nth_element(nearest.begin(), nth, nearest.end());
        const Neighbor farthest = *nth;
        const std::uint32_t* const rest = std::remove_if(first, last, [&](std::uint32_t j) {
          return farthest < Neighbor{squared_distance(points[i], points[j]), j};
        });
        m_sizes[i] = static_cast<std::uint32_t>(rest - first);
        m_radii[i] = std::sqrt(farthest.squared_distance);
      }
    };
    loops.for_each_chunk(sizes.size(), shrink_chunk);
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_NEIGHBOR_GRAPH_H
