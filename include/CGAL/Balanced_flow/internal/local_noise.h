// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BALANCED_FLOW_INTERNAL_LOCAL_NOISE_H
#define CGAL_BALANCED_FLOW_INTERNAL_LOCAL_NOISE_H

#include <CGAL/Balanced_flow/internal/find_scale.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// The noise around each point, from the samples next to it: scanners have noise along one
/// direction, and more of it far away.
template <typename ConcurrencyTag>
std::vector<double> local_noise(ConcurrencyTag tag, const std::vector<Point_3>& points,
                                const Sampled_scale& scale, Progress& progress, double work)
{
  std::vector<double> noise(points.size(), scale.noise);
  if (scale.points.empty())
    return noise;
  const Neighbor_tree tree(tag, scale.points);

  // the median over 1/50 of the samples: one alone may lie on a crease
  std::vector<double> at_samples(scale.points.size()), near;
  Neighbor_tree::Query query(tree, scale.points.size() / 50 + 1);
  for (std::size_t i = 0; i < scale.points.size(); ++i) {
    near.assign(1, scale.noises[i]);
    for (const Neighbor_tree::Neighbor& neighbor : query(i))
      near.push_back(scale.noises[neighbor.index]);
    const double local = median(near);
    // small deviations from the whole are chance
    const double chance = 1.25;
    at_samples[i] = local > chance * scale.noise   ? local / chance
                    : local < scale.noise / chance ? local * chance
                                                   : scale.noise;
  }

  for_each_block<ConcurrencyTag>(points.size(), progress, work,
                                 [&](std::size_t begin, std::size_t end) {
                                   Neighbor_tree::Query nearest(tree, 1);
                                   for (std::size_t i = begin; i < end; ++i)
                                     noise[i] = at_samples[nearest(points[i]).front().index];
                                 });
  return noise;
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_BALANCED_FLOW_INTERNAL_LOCAL_NOISE_H
