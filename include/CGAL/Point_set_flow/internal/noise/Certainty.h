// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_NOISE_CERTAINTY_H
#define CGAL_POINT_SET_FLOW_INTERNAL_NOISE_CERTAINTY_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/neighbors/Clearance.h>
#include <CGAL/Point_set_flow/internal/neighbors/Neighbor_graph.h>
#include <CGAL/Point_set_flow/internal/neighbors/Neighbor_tree.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// What of the analysis would be the same if no points were missing. Nothing is looked at if none are.
class Certainty {
  const Clearance& m_clearance;
  Array<Point_3> m_doubtful; // that may be samples or not
  std::optional<Neighbor_tree> m_tree;
  Array<char> m_samples; // whether it is certain what is found around each

public:
  explicit Certainty(const Clearance& clearance) : m_clearance(clearance) {}
  Certainty(const Certainty&) = delete; // the tree knows where the points are
  Certainty& operator=(const Certainty&) = delete;

  /// Whether it is certain what is found around a sample, if it is one.
  bool is_certain(std::size_t sample) const { return m_clearance.is_whole() || m_samples[sample]; }

  /// Whether it is certain which points within a radius are samples.
  bool is_certain(const Point_3& center, double radius) const
  {
    const double rounding = 1e-12, squared_radius = radius * radius * (1. + rounding);
    return !m_tree || m_tree->visit_leaves(
                          Box_3(center), squared_radius, [&](std::size_t begin, std::size_t end) {
                            for (std::size_t i = begin; i < end; ++i)
                              if (squared_distance(center, m_doubtful[i]) <= squared_radius)
                                return false;
                            return true;
                          });
  }

  /// Finds the points that may be samples or not: that depends on three rings of neighbors.
  /// \param radii the distance of the farthest of the `k` nearest neighbors of each point
  template <typename ConcurrencyTag>
  void check_choice(const Array<Point_3>& points, const Neighbor_graph& graph,
                    const Array<double>& radii, std::size_t k, Loops<ConcurrencyTag>& loops)
  {
    if (m_clearance.is_whole())
      return;
    Array<char> certain(points.size());
    loops.for_each_chunk(points.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        certain[i] = m_clearance.holds(i, searched_radius(graph.size(i), k, radii[i]));
    });
    for (int ring = 1; ring < 3; ++ring)
      leave_out_neighbors_of_doubtful(graph, k, certain, loops);
    for (std::size_t i = 0; i < points.size(); ++i)
      if (!certain[i])
        m_doubtful.push_back(points[i]);
    if (!m_doubtful.empty())
      m_tree.emplace(m_doubtful, loops);
  }

  /// Finds the samples around which all is certain that was pooled.
  /// \param sites, points the samples
  /// \param measured the radius of what was measured around each sample, see `searched_radius()`
  /// \param near the `k` nearest samples of each sample
  /// \param poolings how often something is pooled over the samples around, each time what was pooled
  /// before
  template <typename ConcurrencyTag>
  void check_pools(const std::vector<std::uint32_t>& sites, const Array<Point_3>& points,
                   const Array<double>& measured, const Neighbor_graph& near, std::size_t k,
                   int poolings, Loops<ConcurrencyTag>& loops)
  {
    if (m_clearance.is_whole())
      return;
    Array<char> pools(sites.size());
    m_samples.resize(sites.size());
    loops.for_each_chunk(sites.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const double radius = searched_radius(near.size(i), k, near.radius(i));
        pools[i] = m_clearance.holds(sites[i], radius) && is_certain(points[i], radius);
        m_samples[i] = m_clearance.holds(sites[i], measured[i]);
      }
    });
    for (int pooling = 0; pooling < poolings; ++pooling) {
      leave_out_neighbors_of_doubtful(near, k, m_samples, loops);
      for (std::size_t i = 0; i < sites.size(); ++i)
        m_samples[i] = m_samples[i] && pools[i];
    }
  }

private:
  template <typename ConcurrencyTag>
  static void leave_out_neighbors_of_doubtful(const Neighbor_graph& graph, std::size_t k,
                                              Array<char>& certain, Loops<ConcurrencyTag>& loops)
  {
    Array<char> left(certain.size());
    loops.for_each_chunk(certain.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const Neighbor_numbers near = graph.neighbors(i).nearest(k);
        left[i] = certain[i];
        for (std::size_t j = 0; left[i] && j < near.size(); ++j)
          left[i] = certain[near[j]];
      }
    });
    certain.swap(left);
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_NOISE_CERTAINTY_H
