// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_NOISE_NOISE_MAP_H
#define CGAL_POINT_SET_FLOW_INTERNAL_NOISE_NOISE_MAP_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/noise/Scale_samples.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// The noise around each place, from the samples next to it: scanners have noise along one
/// direction, and more of it far away.
class Noise_map {
  Scale_samples m_samples;
  Neighbor_tree m_tree;             // of the samples
  std::vector<double> m_at_samples; // pooled over the samples around each

public:
  template <typename ConcurrencyTag>
  Noise_map(Scale_samples samples, Loops<ConcurrencyTag>& loops)
      : m_samples(std::move(samples)), m_tree(m_samples.points(), loops),
        m_at_samples(m_samples.points().size())
  {
    if (m_at_samples.empty())
      return;
    // the median over 1/50 of the samples: one alone may lie on a crease
    std::vector<double> near;
    Neighbor_query query(m_tree, m_at_samples.size() / 50 + 1);
    for (std::size_t i = 0; i < m_at_samples.size(); ++i) {
      near.assign(1, m_samples.noises()[i]);
      for (const Neighbor& neighbor : query(i))
        near.push_back(m_samples.noises()[neighbor.index]);
      const double local = median(near);
      // smaller deviations from the global noise are sampling error
      const double significant = 1.25;
      m_at_samples[i] = local > significant * noise()   ? local / significant
                        : local < noise() / significant ? local * significant
                                                        : noise();
    }
  }

  Noise_map(const Noise_map&) = delete;
  Noise_map& operator=(const Noise_map&) = delete;

  const Scale_samples& samples() const { return m_samples; }
  /// of the whole point set
  double noise() const { return m_samples.noise(); }
  /// of the whole point set
  double spacing() const { return m_samples.spacing(); }

  /// the least and the greatest noise of all places
  std::pair<double, double> noise_range() const
  {
    if (m_at_samples.empty())
      return {noise(), noise()};
    const auto range = std::minmax_element(m_at_samples.begin(), m_at_samples.end());
    return {*range.first, *range.second};
  }

  template <typename ConcurrencyTag>
  Array<double> noise_at(const Array<Point_3>& points, Loops<ConcurrencyTag>& loops) const
  {
    Array<double> noise(points.size());
    const auto look_up = [&](std::size_t begin, std::size_t end) {
      Neighbor_query nearest(m_tree, 1);
      for (std::size_t i = begin; i < end; ++i)
        noise[i] = m_at_samples.empty() ? m_samples.noise()
                                        : m_at_samples[nearest(points[i]).front().index];
    };
    loops.for_each_chunk(points.size(), look_up);
    return noise;
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_NOISE_NOISE_MAP_H
