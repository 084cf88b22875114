// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_PARALLEL_LOOPS_H
#define CGAL_POINT_SET_FLOW_INTERNAL_PARALLEL_LOOPS_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/parallel/Progress.h>
#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>
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

/// The points that one task works on. The borders of the chunks depend on the number of points
/// only, never on the number of threads: sums taken chunk by chunk are the same in any run.
constexpr std::size_t chunk_size = 1024;

/// How the loops of a run are executed: by one thread or by many, in isolation from other tasks of
/// the caller, reporting progress, and until the caller cancels.
template <typename ConcurrencyTag>
class Loops : public Progress {
  static constexpr bool is_parallel = std::is_convertible<ConcurrencyTag, Parallel_tag>::value;
#ifndef CGAL_LINKED_WITH_TBB
  static_assert(!is_parallel, "Parallel_tag is enabled but TBB is unavailable.");
#endif

public:
  typedef ConcurrencyTag Concurrency_tag;
  using Progress::Progress;

  /// Calls `body(begin, end)` for each chunk of `[0, n)`, in parallel if asked to. Chunks must not
  /// depend on each other. Every few chunks the callback is called; if it cancels, running
  /// chunks finish, and no other begins.
  template <typename Body>
  void for_each_chunk(std::size_t n, const Body& body, std::size_t size = chunk_size)
  {
    const double cost = begin_loop();
    const std::size_t chunks = (n + size - 1) / size;
    const std::size_t interval = 4; // chunks between two calls of the callback
    std::size_t reported = 0;
    const auto report = [&](std::size_t done) {
      advance(cost * (double(done - reported) / double(chunks)));
      reported = done;
    };
    const auto run_chunk = [&](std::size_t c) { body(c * size, (std::min)((c + 1) * size, n)); };
#ifdef CGAL_LINKED_WITH_TBB
    if constexpr (is_parallel) {
      // the calling thread runs chunks, too, and is the only one that calls the callback
      const std::thread::id caller = std::this_thread::get_id();
      std::atomic<std::size_t> done{0};
      const auto run_and_report = [&](std::size_t c) {
        done.load(std::memory_order_acquire);
        run_chunk(c);
        const std::size_t so_far = ++done;
        if (std::this_thread::get_id() == caller && so_far >= reported + interval)
          report(so_far);
      };
      // A task sees what the caller and finished tasks have written. TBB guarantees that, too,
      // but not in a way that the thread sanitizer can see.
      done.store(0, std::memory_order_release);
      tbb::parallel_for(std::size_t(0), chunks, run_and_report, tbb::simple_partitioner());
    }
    else
#endif
      for (std::size_t c = 0; c < chunks; ++c) {
        run_chunk(c);
        if (c + 1 >= reported + interval)
          report(c + 1);
      }
    if (reported < chunks)
      report(chunks);
  }

  /// Sorts by `<`, in parallel if asked to.
  template <typename Iterator>
  void sort(Iterator first, Iterator last) const
  {
#ifdef CGAL_LINKED_WITH_TBB
    if constexpr (is_parallel)
      tbb::parallel_sort(first, last);
    else
#endif
      std::sort(first, last);
  }

  /// Calls a function that runs loops, and returns what it returns. A thread that waits for the end
  /// of a loop does not meanwhile begin other tasks of the caller, which may be long.
  template <typename Function>
  static auto in_isolation(const Function& function)
  {
#ifdef CGAL_LINKED_WITH_TBB
    if constexpr (is_parallel)
      return tbb::this_task_arena::isolate(function);
    else
#endif
      return function();
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_PARALLEL_LOOPS_H
