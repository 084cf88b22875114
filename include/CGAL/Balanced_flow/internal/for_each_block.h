// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BALANCED_FLOW_INTERNAL_FOR_EACH_BLOCK_H
#define CGAL_BALANCED_FLOW_INTERNAL_FOR_EACH_BLOCK_H

#include <CGAL/Balanced_flow/internal/Progress.h>
#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/parallel_for.h>
#endif

#include <algorithm>
#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// The points that one task works on. The borders of the blocks depend on the number of points
/// only, never on the number of threads: sums taken block by block are the same in any run.
constexpr std::size_t block_size = 1024;

/// Calls `body(begin, end)` for each block of `[0, n)`, in parallel if asked to. Blocks must not
/// depend on each other.
/// \param work what the whole loop counts in the progress
template <typename ConcurrencyTag, typename Body>
void for_each_block(std::size_t n, Progress& progress, double work, const Body& body,
                    std::size_t size = block_size)
{
#ifndef CGAL_LINKED_WITH_TBB
  static_assert(!std::is_convertible<ConcurrencyTag, Parallel_tag>::value,
                "Parallel_tag is enabled but TBB is unavailable.");
#endif
  // Blocks run in groups, and between two groups the callback is asked. A group is large enough
  // to keep many threads busy and small enough to answer a callback that cancels.
  const std::size_t group_size = 64 * size;
  for (std::size_t group = 0; group < n; group += group_size) {
    const std::size_t group_end = (std::min)(group + group_size, n);
    const std::size_t blocks = (group_end - group + size - 1) / size;
    const auto run_block = [&](std::size_t b) {
      const std::size_t begin = group + b * size;
      body(begin, (std::min)(begin + size, group_end));
    };
#ifdef CGAL_LINKED_WITH_TBB
    if constexpr (std::is_convertible<ConcurrencyTag, Parallel_tag>::value)
      tbb::parallel_for(std::size_t(0), blocks, run_block, tbb::simple_partitioner());
    else
#endif
      for (std::size_t b = 0; b < blocks; ++b)
        run_block(b);
    progress.advance(work * (double(group_end - group) / double(n)));
  }
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_BALANCED_FLOW_INTERNAL_FOR_EACH_BLOCK_H
