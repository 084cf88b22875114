// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_NOISE_NOISE_MAP_H
#define CGAL_POINT_SET_FLOW_INTERNAL_NOISE_NOISE_MAP_H

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
  Sampled_scale m_scale;
  Neighbor_tree m_tree;             // of the samples
  std::vector<double> m_at_samples; // what the samples around each of them say

public:
  template <typename ConcurrencyTag>
  Noise_map(ConcurrencyTag tag, Sampled_scale scale, Progress& progress)
      : m_scale(std::move(scale)), m_tree(tag, m_scale.points, progress),
        m_at_samples(m_scale.points.size())
  {
    if (m_scale.points.empty())
      return;
    // the median over 1/50 of the samples: one alone may lie on a crease
    std::vector<double> near;
    Neighbor_tree::Query query(m_tree, m_scale.points.size() / 50 + 1);
    for (std::size_t i = 0; i < m_scale.points.size(); ++i) {
      near.assign(1, m_scale.noises[i]);
      for (const Neighbor_tree::Neighbor& neighbor : query(i))
        near.push_back(m_scale.noises[neighbor.index]);
      const double local = median(near);
      // small deviations from the whole are chance
      const double chance = 1.25;
      m_at_samples[i] = local > chance * m_scale.noise   ? local / chance
                        : local < m_scale.noise / chance ? local * chance
                                                         : m_scale.noise;
    }
  }

  /// the sites of the samples
  const std::vector<std::uint32_t>& samples() const { return m_scale.sites; }
  double noise() const { return m_scale.noise; }
  double spacing() const { return m_scale.spacing; }

  /// of all places
  double largest() const
  {
    double largest = m_scale.noise;
    for (const double noise : m_at_samples)
      largest = (std::max)(largest, noise);
    return largest;
  }

  template <typename ConcurrencyTag>
  Array<double> noise_at(ConcurrencyTag, const Array<Point_3>& points, Progress& progress,
                         double work) const
  {
    Array<double> noise(points.size());
    const auto look_up = [&](std::size_t begin, std::size_t end) {
      Neighbor_tree::Query nearest(m_tree, 1);
      for (std::size_t i = begin; i < end; ++i)
        noise[i] =
            m_at_samples.empty() ? m_scale.noise : m_at_samples[nearest(points[i]).front().index];
    };
    for_each_block<ConcurrencyTag>(points.size(), progress, work, look_up);
    return noise;
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_NOISE_NOISE_MAP_H
