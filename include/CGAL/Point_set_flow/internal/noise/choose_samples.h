// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_NOISE_CHOOSE_SAMPLES_H
#define CGAL_POINT_SET_FLOW_INTERNAL_NOISE_CHOOSE_SAMPLES_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/neighbors/cut_graph.h>
#include <CGAL/Point_set_flow/internal/noise/Certainty.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// The number of neighbors by which samples are chosen
constexpr std::size_t choice_size = 16;

inline Neighbor_numbers nearest_for_choice(const Neighbor_graph& graph, std::size_t i)
{
  return graph.neighbors(i).nearest(choice_size);
}

/// About one point of 18: those whose neighborhood radius deviates less from the mean of their
/// neighbors' than that of each neighbor does. Which these are depends on the points around only, and
/// not on how the data are translated, rotated, scaled or numbered; and they favor neither dense nor
/// sparse places.
/// \param graph of all points, with at least 16 neighbors each
/// \param certainty learns which choices are doubtful
template <typename ConcurrencyTag>
std::vector<std::uint32_t> choose_samples(const Array<Point_3>& points, const Neighbor_graph& graph,
                                          Certainty& certainty, Loops<ConcurrencyTag>& loops)
{
  const std::size_t n = points.size();
  Array<double> radius(n), deviation(n);
  const auto find_radii = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Neighbor_numbers near = nearest_for_choice(graph, i);
      radius[i] = near.size() == 0
                      ? 0.
                      : std::sqrt(squared_distance(points[i], points[near[near.size() - 1]]));
    }
  };
  loops.for_each_chunk(n, find_radii);
  certainty.check_choice(points, graph, radius, choice_size, loops);
  const auto find_deviations = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Neighbor_numbers near = nearest_for_choice(graph, i);
      double sum = 0.;
      for (std::size_t j = 0; j < near.size(); ++j)
        sum += radius[near[j]];
      deviation[i] = std::abs(sum - double(near.size()) * radius[i]);
    }
  };
  loops.for_each_chunk(n, find_deviations);

  Array<char> chosen(n);
  const auto choose = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      chosen[i] = 1;
      const Neighbor_numbers near = nearest_for_choice(graph, i);
      for (std::size_t j = 0; chosen[i] && j < near.size(); ++j) {
        const std::size_t other = near[j];
        chosen[i] =
            deviation[i] < deviation[other] || (deviation[i] == deviation[other] && i < other);
      }
    }
  };
  loops.for_each_chunk(n, choose);
  std::vector<std::uint32_t> sites;
  for (std::size_t i = 0; i < n; ++i)
    if (chosen[i])
      sites.push_back(static_cast<std::uint32_t>(i));
  return sites;
}

/// The same samples, chosen block by block to save memory: the choice depends on three rings of neighbors.
/// \param tree of all points, of which none are missing
template <typename ConcurrencyTag>
std::vector<std::uint32_t> choose_samples_in_blocks(const Neighbor_tree& tree,
                                                    std::size_t block_size,
                                                    Loops<ConcurrencyTag>& loops)
{
  const std::size_t rings = 3;
  const Clearance whole;
  std::vector<std::uint32_t> sites;
  const auto choose = [&](const Cut_graph& cut, std::size_t begin, std::size_t end) {
    Array<Point_3> points;
    points.reserve(cut.sites.size());
    for (const std::uint32_t site : cut.sites)
      points.push_back(tree.points()[site]);
    Certainty certainty(whole);
    for (const std::uint32_t place : choose_samples(points, cut.graph, certainty, loops))
      if (cut.sites[place] >= begin && cut.sites[place] < end)
        sites.push_back(cut.sites[place]);
  };
  for_each_cut(tree, {choice_size}, block_size, rings, choose, loops);
  return sites;
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_NOISE_CHOOSE_SAMPLES_H
