// SPDX-License-Identifier: GPL-3.0-or-later
// Calls from several threads, arenas and tasks at once.
#define BOOST_TEST_MODULE thread_safety
#include <boost/test/unit_test.hpp>

#include "shapes.h"

#include <CGAL/balanced_flow_smooth_point_set.h>
#include <CGAL/estimate_point_set_noise.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>
#endif

#include <atomic>
#include <thread>

namespace np = CGAL::parameters;
using namespace CGAL::Point_set_flow;
using shapes::noisy_cube;
using shapes::Points;
typedef CGAL::Sequential_tag Sequential;

BOOST_AUTO_TEST_CASE(calls_from_many_threads_do_not_disturb_each_other)
{
  std::vector<Points> clouds, expected;
  for (int i = 0; i < 6; ++i) {
    clouds.push_back(noisy_cube(10 + i, .02));
    expected.push_back(clouds.back());
    CGAL::balanced_flow_smooth_point_set<Sequential>(expected.back());
  }
  std::vector<std::thread> threads;
  std::atomic<int> called_elsewhere{0};
  for (Points& cloud : clouds)
    threads.emplace_back([&cloud, &called_elsewhere]() {
      const std::thread::id caller = std::this_thread::get_id();
      const auto callback = [&](double) {
        if (std::this_thread::get_id() != caller)
          ++called_elsewhere;
        return true;
      };
      CGAL::balanced_flow_smooth_point_set<CGAL::Parallel_if_available_tag>(cloud,
                                                                            np::callback(callback));
    });
  for (std::thread& thread : threads)
    thread.join();
  BOOST_TEST(called_elsewhere == 0);
  for (std::size_t i = 0; i < clouds.size(); ++i)
    BOOST_TEST((clouds[i] == expected[i]));
}

#ifdef CGAL_LINKED_WITH_TBB
namespace {
/// Calls `run` with 0 to n-1 in tasks. The counter is for the thread sanitizer, which does not see
/// how TBB hands over what was written before, as in Loops.h.
template <typename Run>
void for_each_task(std::size_t n, const Run& run)
{
  std::atomic<std::size_t> done;
  done.store(0, std::memory_order_release);
  tbb::parallel_for(std::size_t(0), n, [&](std::size_t i) {
    done.load(std::memory_order_acquire);
    run(i);
    ++done;
  });
  done.load(std::memory_order_acquire);
}

/// How many of many calls are begun by a thread that is inside of another one
template <typename Call>
int number_of_nested_calls(const Call& call)
{
  std::atomic<int> nested{0};
  for_each_task(64, [&](std::size_t) {
    static thread_local int depth = 0;
    if (depth++ > 0)
      ++nested;
    call();
    --depth;
  });
  return nested;
}
} // namespace

BOOST_AUTO_TEST_CASE(calls_from_arenas_and_tasks_do_not_disturb_each_other)
{
  const Points noisy = noisy_cube(20);
  Points expected = noisy, in_arena = noisy;
  CGAL::balanced_flow_smooth_point_set<Sequential>(expected);
  tbb::task_arena(1).execute(
      [&]() { CGAL::balanced_flow_smooth_point_set<CGAL::Parallel_tag>(in_arena); });
  BOOST_TEST((in_arena == expected));

  std::vector<Points> clouds(8, noisy);
  for_each_task(clouds.size(), [&](std::size_t i) {
    CGAL::balanced_flow_smooth_point_set<CGAL::Parallel_tag>(clouds[i]);
  });
  for (const Points& cloud : clouds)
    BOOST_TEST((cloud == expected));
}

BOOST_AUTO_TEST_CASE(a_thread_that_waits_for_a_loop_does_not_begin_another_call)
{
  const Points noisy = noisy_cube(20);
  BOOST_TEST(number_of_nested_calls([&] {
               Points cloud = noisy;
               CGAL::balanced_flow_smooth_point_set<CGAL::Parallel_tag>(cloud);
             }) == 0);
}

namespace {
/// How many tasks of the caller a thread runs while it is inside of `call`: another thread makes tasks
/// all the time, which whoever has nothing to do runs
template <typename Call>
int number_of_tasks_run_inside(const Call& call)
{
  static thread_local bool is_inside = false;
  std::atomic<int> run_inside{0}, pending{0};
  std::atomic<bool> is_done{false};
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, 4);
  tbb::task_arena arena(4);
  std::thread task_maker([&] {
    arena.execute([&] {
      tbb::task_group group;
      while (!is_done) {
        for (; pending < 100; ++pending)
          group.run([&] {
            --pending;
            if (is_inside)
              ++run_inside;
          });
        std::this_thread::yield();
      }
      group.wait();
    });
  });
  arena.execute([&] {
    for (int i = 0; i < 20; ++i) {
      is_inside = true;
      call();
      is_inside = false;
    }
  });
  is_done = true;
  task_maker.join();
  return run_inside;
}
} // namespace

BOOST_AUTO_TEST_CASE(a_thread_that_waits_in_a_call_does_not_run_tasks_of_the_caller)
{
  const Points noisy = noisy_cube(40);
  Points points;
  BOOST_TEST(number_of_tasks_run_inside([&] {
               points = noisy;
               CGAL::balanced_flow_smooth_point_set<CGAL::Parallel_tag>(points);
             }) == 0);
  BOOST_TEST(number_of_tasks_run_inside(
                 [&] { estimate_point_set_scale<CGAL::Parallel_tag>(noisy); }) == 0);
  BOOST_TEST(number_of_tasks_run_inside(
                 [&] { CGAL::estimate_point_set_noise<CGAL::Parallel_tag>(noisy); }) == 0);
}

BOOST_AUTO_TEST_CASE(a_call_canceled_in_a_task_does_not_cancel_the_others)
{
  const Points noisy = noisy_cube(20);
  Points expected = noisy;
  CGAL::balanced_flow_smooth_point_set<Sequential>(expected);
  std::vector<Points> clouds(8, noisy);
  for_each_task(clouds.size(), [&](std::size_t i) {
    CGAL::balanced_flow_smooth_point_set<CGAL::Parallel_tag>(
        clouds[i],
        np::callback([i](double share) { return i % 2 == 0 || share < .1 * double(i); }));
  });
  for (std::size_t i = 0; i < clouds.size(); ++i)
    BOOST_TEST((clouds[i] == (i % 2 == 0 ? expected : noisy)));
}
#endif
