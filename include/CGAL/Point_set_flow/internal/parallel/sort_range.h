// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_PARALLEL_SORT_RANGE_H
#define CGAL_POINT_SET_FLOW_INTERNAL_PARALLEL_SORT_RANGE_H

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/parallel_sort.h>
#endif

#include <algorithm>
#include <type_traits>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// Sorts by `<`, in parallel if asked to.
template <typename ConcurrencyTag, typename Iterator>
void sort_range(Iterator first, Iterator last)
{
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr (std::is_convertible<ConcurrencyTag, Parallel_tag>::value)
    tbb::parallel_sort(first, last);
  else
#endif
    std::sort(first, last);
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_PARALLEL_SORT_RANGE_H
