// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_NOISE_CHOOSE_SAMPLES_H
#define CGAL_POINT_SET_FLOW_INTERNAL_NOISE_CHOOSE_SAMPLES_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/neighbors/Neighbor_graph.h>
#include <CGAL/Point_set_flow/internal/noise/Certainty.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// About one point of 18: those whose neighborhood radius deviates less from the mean of their
/// neighbors' than that of each neighbor does. Which these are depends on the points around only, and
/// not on how the data are translated, rotated, scaled or numbered; and they favor neither dense nor
/// sparse places.
/// \param certainty learns which choices are doubtful
template <typename ConcurrencyTag>
std::vector<std::uint32_t> choose_samples(const Neighbor_tree& tree, Certainty& certainty,
                                          Loops<ConcurrencyTag>& loops)
{
  const std::size_t n = tree.points().size(), few = 16;
  const Neighbor_graph graph(tree, {few, 0., {}}, loops);
  certainty.check_choice(tree.points(), graph, few, loops);
  Array<double> deviation(n);
  const auto find_deviations = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      double sum = 0.;
      for (std::size_t j = 0; j < graph.size(i); ++j)
        sum += graph.radius(graph.neighbors(i)[j]);
      deviation[i] = std::abs(sum - double(graph.size(i)) * graph.radius(i));
    }
  };
  loops.for_each_chunk(n, find_deviations);

  Array<char> chosen(n);
  const auto choose = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      chosen[i] = 1;
      for (std::size_t j = 0; chosen[i] && j < graph.size(i); ++j) {
        const std::size_t other = graph.neighbors(i)[j];
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

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_NOISE_CHOOSE_SAMPLES_H
