// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_SEARCH_OPTIONS_H
#define CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_SEARCH_OPTIONS_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/parallel/Array.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// How to search the neighbors
struct Search_options {
  std::size_t k = 0;
  double radius = 0.; ///< the distance beyond which there are no neighbors, 0 for no limit
  /// instead of `k`, if not empty: the number of neighbors of each part of the point set
  std::vector<std::uint32_t> k_of_parts = {};
  const Array<std::uint32_t>* part_of = nullptr; ///< for each point

  std::size_t k_of(std::size_t site) const
  {
    return k_of_parts.empty() ? k : k_of_parts[(*part_of)[site]];
  }
  /// How many neighbors a site has among `n`.
  std::size_t k_of(std::size_t site, std::size_t n) const { return (std::min)(k_of(site), n - 1); }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_SEARCH_OPTIONS_H
