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

/// The nearest neighbors of all points, in one flat array.
class Neighbor_graph {
  std::size_t m_stride;
  Array<std::uint32_t> m_neighbors; // m_stride entries for each point
  Array<std::uint32_t> m_sizes;     // how many of them count
  Array<double> m_radii;            // the distance of the farthest neighbor

  explicit Neighbor_graph(std::size_t stride) : m_stride(stride) {}

public:
  /// A graph without points yet
  Neighbor_graph(const Neighbor_tree& tree, std::size_t k)
      : m_stride(tree.points().empty() ? 0 : (std::min)(k, tree.points().size() - 1))
  {}

  template <typename ConcurrencyTag>
  Neighbor_graph(const Neighbor_tree& tree, const Search_options& search,
                 Loops<ConcurrencyTag>& loops)
      : Neighbor_graph(tree, search.k)
  {
    typedef boost::counting_iterator<std::size_t> Site;
    add(tree, Site(0), Site(tree.points().size()), search.radius, loops);
  }

  /// Adds points of the tree, which follow each other in space, with their neighbors.
  template <typename ConcurrencyTag, typename Iterator>
  void add(const Neighbor_tree& tree, Iterator first, Iterator last, double radius,
           Loops<ConcurrencyTag>& loops)
  {
    const std::size_t before = m_radii.size(), count = std::size_t(last - first);
    if (m_stride == 0) {
      m_sizes.resize(before + count, 0);
      m_radii.resize(before + count, 0.);
      return;
    }
    m_neighbors.resize(offset(before + count, m_stride));
    m_sizes.resize(before + count);
    m_radii.resize(before + count);
    loops.for_each_chunk(count, [&](std::size_t begin, std::size_t end) {
      Group_search search(tree, m_stride, radius);
      std::size_t i = before + begin;
      search(first + std::ptrdiff_t(begin), first + std::ptrdiff_t(end),
             [&](const std::vector<std::uint32_t>& found, double farthest) {
               std::copy(found.begin(), found.end(),
                         m_neighbors.begin() + std::ptrdiff_t(offset(i, m_stride)));
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
    Neighbor_graph graph(m_stride);
    graph.m_neighbors.assign(offset(numbers.size(), m_stride), 0);
    graph.m_sizes.assign(numbers.size(), 0);
    graph.m_radii.assign(numbers.size(), 0.);
    for (std::size_t i = 0; i < m_radii.size(); ++i) {
      const std::size_t here = place[numbers[i]];
      graph.m_sizes[here] = m_sizes[i];
      graph.m_radii[here] = m_radii[i];
      for (std::size_t j = 0; j < m_sizes[i]; ++j)
        graph.m_neighbors[offset(here, m_stride) + j] = place[neighbors(i)[j]];
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

  /// Where the neighbors of a point begin: there may be more of them than \f$2^{32}\f$.
  static constexpr std::size_t offset(std::size_t i, std::size_t stride) { return i * stride; }

  std::size_t size(std::size_t i) const { return m_sizes[i]; }
  std::size_t largest_size() const { return m_stride; }
  const std::uint32_t* neighbors(std::size_t i) const
  {
    return m_neighbors.data() + offset(i, m_stride);
  }
  double radius(std::size_t i) const { return m_radii[i]; }
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
        std::uint32_t* const first = m_neighbors.data() + offset(i, m_stride);
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
