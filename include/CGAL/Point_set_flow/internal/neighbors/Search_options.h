// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_SEARCH_OPTIONS_H
#define CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_SEARCH_OPTIONS_H

#include <CGAL/license/Point_set_flow.h>

#include <cstddef>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// How to search the neighbors
struct Search_options {
  std::size_t k = 0;
  double radius = 0.; ///< the distance beyond which there are no neighbors, 0 for no limit
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_SEARCH_OPTIONS_H
