// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_PARALLEL_LOOPS_H
#define CGAL_POINT_SET_FLOW_INTERNAL_PARALLEL_LOOPS_H

#include <CGAL/Point_set_flow/internal/parallel/Progress.h>
#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>
#include <type_traits>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// The points that one task works on. The borders of the blocks depend on the number of points
/// only, never on the number of threads: sums taken block by block are the same in any run.
constexpr std::size_t block_size = 1024;

/// Calls `body(begin, end)` for each block of `[0, n)`, in parallel if asked to. Blocks must not
/// depend on each other. Every few blocks the callback is asked; if it cancels, those that run come to
/// their end, and no other begins.
/// \param work what the whole loop counts in the progress
template <typename ConcurrencyTag, typename Body>
void for_each_block(std::size_t n, Progress& progress, double work, const Body& body,
                    std::size_t size = block_size)
{
#ifndef CGAL_LINKED_WITH_TBB
  static_assert(!std::is_convertible<ConcurrencyTag, Parallel_tag>::value,
                "Parallel_tag is enabled but TBB is unavailable.");
#endif
  const std::size_t blocks = (n + size - 1) / size, often = 4;
  std::size_t reported = 0;
  const auto report = [&](std::size_t done) {
    progress.advance(work * (double(done - reported) / double(blocks)));
    reported = done;
  };
  const auto run_block = [&](std::size_t b) { body(b * size, (std::min)((b + 1) * size, n)); };
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr (std::is_convertible<ConcurrencyTag, Parallel_tag>::value) {
    // the thread of the caller has its share of the blocks, and is the only one that may ask
    const std::thread::id caller = std::this_thread::get_id();
    std::atomic<std::size_t> done{0};
    const auto run_and_report = [&](std::size_t b) {
      done.load(std::memory_order_acquire);
      run_block(b);
      const std::size_t so_far = ++done;
      if (std::this_thread::get_id() == caller && so_far >= reported + often)
        report(so_far);
    };
    // A task sees what the caller and the tasks that are done have written. TBB makes sure of that,
    // too, but not in a way that the sanitizer for threads can see.
    done.store(0, std::memory_order_release);
    tbb::parallel_for(std::size_t(0), blocks, run_and_report, tbb::simple_partitioner());
  }
  else
#endif
    for (std::size_t b = 0; b < blocks; ++b) {
      run_block(b);
      if (b + 1 >= reported + often)
        report(b + 1);
    }
  if (reported < blocks)
    report(blocks);
}

/// Calls a function that runs loops, and returns what it returns. A thread that waits for the end of a
/// loop does not meanwhile begin other tasks of the caller, which may be long.
template <typename ConcurrencyTag, typename Function>
auto in_isolation(const Function& function)
{
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr (std::is_convertible<ConcurrencyTag, Parallel_tag>::value)
    return tbb::this_task_arena::isolate(function);
  else
#endif
    return function();
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_PARALLEL_LOOPS_H
