// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BALANCED_FLOW_INTERNAL_NEIGHBOR_GRAPH_H
#define CGAL_BALANCED_FLOW_INTERNAL_NEIGHBOR_GRAPH_H

#include <CGAL/Balanced_flow/Neighborhood_3.h>
#include <CGAL/Balanced_flow/internal/Group_search.h>
#include <CGAL/Balanced_flow/internal/for_each_block.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// The nearest neighbours of all points, in one flat array.
class Neighbor_graph {
  std::size_t m_stride;
  std::vector<std::uint32_t> m_neighbors; // m_stride entries for each point
  std::vector<std::uint32_t> m_sizes;     // empty if each point has m_stride neighbours
  std::vector<double> m_radii;            // the distance of the farthest neighbour

public:
  /// \param radius the distance beyond which there are no neighbours, 0 for no limit
  template <typename ConcurrencyTag>
  Neighbor_graph(ConcurrencyTag, const Neighbor_tree& tree, std::size_t k, double radius,
                 Progress& progress, double work)
      : m_stride(tree.points().empty() ? 0 : (std::min)(k, tree.points().size() - 1))
  {
    const std::size_t n = tree.points().size();
    m_neighbors.resize(n * m_stride);
    m_radii.resize(n);
    if (radius > 0.)
      m_sizes.resize(n);
    if (m_stride == 0)
      return;

    for_each_block<ConcurrencyTag>(n, progress, work, [&](std::size_t begin, std::size_t end) {
      typedef boost::counting_iterator<std::size_t> Site;
      Group_search search(tree, m_stride, radius);
      search(Site(begin), Site(end),
             [&](std::size_t i, const std::vector<std::uint32_t>& found, double farthest) {
               std::copy(found.begin(), found.end(),
                         m_neighbors.begin() + std::ptrdiff_t(i * m_stride));
               m_radii[i] = farthest;
               if (!m_sizes.empty())
                 m_sizes[i] = static_cast<std::uint32_t>(found.size());
             });
    });
  }

  /// \param points where the points are now
  /// \param filter_width the width of the Gaussian in multiples of the neighbourhood radius
  /// \param surface what else is known of the surface around point `i`
  Neighborhood_3 neighborhood(const std::vector<Point_3>& points, std::size_t i,
                              double filter_width,
                              const Surface_estimate_3& surface = Surface_estimate_3()) const
  {
    return Neighborhood_3(points.data(), i, neighbors(i), size(i), m_radii[i], filter_width,
                          surface);
  }

  std::size_t size(std::size_t i) const { return m_sizes.empty() ? m_stride : m_sizes[i]; }
  std::size_t largest_size() const { return m_stride; }
  const std::uint32_t* neighbors(std::size_t i) const { return m_neighbors.data() + i * m_stride; }
  double radius(std::size_t i) const { return m_radii[i]; }

  /// Leaves each point the nearest of its neighbours.
  /// \param points where the points were when the graph was made
  /// \param sizes how many, for each point; more than there are is as many as there are
  template <typename ConcurrencyTag>
  void shrink(const std::vector<Point_3>& points, const std::vector<std::uint32_t>& sizes,
              Progress& progress, double work)
  {
    m_sizes.resize(m_radii.size(), static_cast<std::uint32_t>(m_stride));
    const auto shrink_block = [&](std::size_t begin, std::size_t end) {
      std::vector<Neighbor_tree::Neighbor> nearest;
      for (std::size_t i = begin; i < end; ++i) {
        if (sizes[i] >= m_sizes[i] || sizes[i] == 0)
          continue;
        std::uint32_t* const first = m_neighbors.data() + i * m_stride;
        std::uint32_t* const last = first + m_sizes[i];
        nearest.clear();
        for (const std::uint32_t* j = first; j != last; ++j)
          nearest.push_back({squared_distance(points[i], points[*j]), *j});
        const auto nth = nearest.begin() + (sizes[i] - 1);
        std::nth_element(nearest.begin(), nth, nearest.end());
        const Neighbor_tree::Neighbor farthest = *nth;
        std::remove_if(first, last, [&](std::uint32_t j) {
          return farthest < Neighbor_tree::Neighbor{squared_distance(points[i], points[j]), j};
        });
        m_sizes[i] = sizes[i];
        m_radii[i] = std::sqrt(farthest.squared_distance);
      }
    };
    for_each_block<ConcurrencyTag>(sizes.size(), progress, work, shrink_block);
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_BALANCED_FLOW_INTERNAL_NEIGHBOR_GRAPH_H
