// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_PARALLEL_ARRAY_H
#define CGAL_POINT_SET_FLOW_INTERNAL_PARALLEL_ARRAY_H

#include <CGAL/license/Point_set_flow.h>

#include <boost/core/noinit_adaptor.hpp>

#include <memory>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// A vector of something for each point. Its elements are not initialized when it gets its size, so
/// that the threads that fill it are the first to touch its memory, each its share.
template <typename T>
using Array = std::vector<T, boost::noinit_adaptor<std::allocator<T>>>;

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_PARALLEL_ARRAY_H
