// SPDX-License-Identifier: GPL-3.0-or-later
// Where memory ends, calls from many threads, minimal kernels, large numbers.
#define BOOST_TEST_MODULE robustness
#include <boost/test/unit_test.hpp>

#include "shapes.h"

#include <CGAL/balanced_flow_smooth_point_set.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

#include <atomic>
#include <cstdlib>
#include <new>
#include <thread>

namespace np = CGAL::parameters;
using namespace CGAL::Point_set_flow;
using shapes::noisy_cube;
using shapes::Points;
typedef CGAL::Sequential_tag Sequential;

// ---- operator new, which fails when it is told to

namespace {
std::atomic<long> allocations_left{-1}; // negative: as many as wanted
std::atomic<long> live_allocations{0};

void* allocate(std::size_t size, std::size_t alignment)
{
  if (allocations_left >= 0 && allocations_left-- == 0) {
    allocations_left = 0; // from now on
    throw std::bad_alloc();
  }
  void* const memory =
      alignment == 0
          ? std::malloc(size == 0 ? 1 : size)
          : std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
  if (!memory)
    throw std::bad_alloc();
  ++live_allocations;
  return memory;
}

void release(void* memory)
{
  if (memory)
    --live_allocations;
  std::free(memory);
}
} // namespace

void* operator new(std::size_t size) { return allocate(size, 0); }
void* operator new(std::size_t size, std::align_val_t alignment)
{
  return allocate(size, std::size_t(alignment));
}
void operator delete(void* memory) noexcept { release(memory); }
void operator delete(void* memory, std::size_t) noexcept { release(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { release(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { release(memory); }

namespace {

typedef std::pair<shapes::Point_3, shapes::Vector_3> Pair;

std::vector<Pair> with_normals(const Points& points)
{
  std::vector<Pair> pairs;
  for (const auto& p : points)
    pairs.emplace_back(p, shapes::Vector_3(0, 0, 1));
  return pairs;
}

/// Whether a run with so many allocations got to its end. If not, nothing may be changed or lost.
template <typename Tag>
bool ends_with(long allocations, const std::vector<Pair>& noisy, unsigned int block_size)
{
  std::vector<Pair> pairs = noisy;
  const long before = live_allocations;
  bool has_ended = true;
  try {
    allocations_left = allocations;
    CGAL::balanced_flow_smooth_point_set<Tag>(
        pairs, 10,
        np::block_size(block_size)
            .number_of_iterations(2)
            .point_map(CGAL::First_of_pair_property_map<Pair>())
            .normal_map(CGAL::Second_of_pair_property_map<Pair>()));
    allocations_left = -1;
  }
  catch (const std::bad_alloc&) {
    allocations_left = -1;
    has_ended = false;
    BOOST_REQUIRE((pairs == noisy));
  }
  // TBB may keep something for itself, and CGAL's kd-tree loses its bounding box when it can not be
  // built (Kd_tree.h, "bbox")
  if (std::is_same<Tag, Sequential>::value)
    BOOST_REQUIRE_MESSAGE(live_allocations <= before + (has_ended ? 0 : 1),
                          live_allocations - before << " left after " << allocations);
  return has_ended;
}

} // namespace

BOOST_AUTO_TEST_CASE(wherever_memory_ends_the_points_are_unchanged_and_nothing_leaks)
{
  const std::vector<Pair> noisy = with_normals(noisy_cube(5));
  ends_with<Sequential>(-1, noisy, 1000); // whatever is made only once
  for (const unsigned int block_size : {1000u, 40u}) {
    long n = 0;
    while (!ends_with<Sequential>(n, noisy, block_size))
      ++n;
    BOOST_TEST_MESSAGE(n << " allocations in blocks of " << block_size);
    BOOST_TEST(n > 50);
  }
}

#ifdef CGAL_LINKED_WITH_TBB
BOOST_AUTO_TEST_CASE(wherever_memory_ends_in_a_task_the_points_are_unchanged)
{
  const std::vector<Pair> noisy = with_normals(noisy_cube(12));
  ends_with<CGAL::Parallel_tag>(-1, noisy, 400); // whatever is made only once
  long n = 0;
  while (!ends_with<CGAL::Parallel_tag>(n, noisy, 400))
    n += 1 + n / 20;
  BOOST_TEST_MESSAGE(n << " allocations in threads");
  BOOST_TEST(n > 50);
}
#endif

// ---- threads

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
/// how TBB hands over what was written before, as in for_each_block.h.
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
} // namespace

BOOST_AUTO_TEST_CASE(calls_from_arenas_and_tasks)
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

  // whoever waits for a loop does not begin with the next cloud meanwhile
  static std::atomic<int> deepest{0};
  for_each_task(64, [&](std::size_t) {
    static thread_local int depth = 0;
    ++depth;
    if (depth > deepest)
      deepest = depth;
    Points cloud = clouds.front();
    CGAL::balanced_flow_smooth_point_set<CGAL::Parallel_tag>(cloud);
    --depth;
  });
  BOOST_TEST(deepest == 1);

  // one that is cancelled inside of a task does not cancel the others
  for_each_task(clouds.size(), [&](std::size_t i) {
    clouds[i] = noisy;
    CGAL::balanced_flow_smooth_point_set<CGAL::Parallel_tag>(
        clouds[i],
        np::callback([i](double share) { return i % 2 == 0 || share < .1 * double(i); }));
  });
  for (std::size_t i = 0; i < clouds.size(); ++i)
    BOOST_TEST((clouds[i] == (i % 2 == 0 ? expected : noisy)));
}
#endif

// ---- kernels

namespace {
/// Points and vectors with nothing but what the documentation asks for
struct Minimal_kernel {
  typedef float FT;
  template <typename>
  struct Ambient_dimension { // CGAL 6.2 asks for it, and for R
    typedef CGAL::Dimension_tag<3> type;
  };
  class Triple {
    float m_x, m_y, m_z;

  public:
    typedef Minimal_kernel R;
    Triple(float x, float y, float z) : m_x(x), m_y(y), m_z(z) {}
    float x() const { return m_x; }
    float y() const { return m_y; }
    float z() const { return m_z; }
  };
  struct Point_3 : Triple {
    using Triple::Triple;
  };
  struct Vector_3 : Triple {
    using Triple::Triple;
  };
};

typedef std::pair<Minimal_kernel::Point_3, Minimal_kernel::Vector_3> Minimal_pair;
} // namespace

BOOST_AUTO_TEST_CASE(a_minimal_kernel_is_enough)
{
  const Points noisy = noisy_cube();
  Points expected;
  std::vector<Minimal_pair> pairs;
  for (const auto& p : noisy) {
    pairs.emplace_back(Minimal_kernel::Point_3(float(p.x()), float(p.y()), float(p.z())),
                       Minimal_kernel::Vector_3(0, 0, 1));
    expected.emplace_back(float(p.x()), float(p.y()), float(p.z()));
  }
  CGAL::balanced_flow_smooth_point_set<Sequential>(expected, 20);
  CGAL::balanced_flow_smooth_point_set<Sequential>(
      pairs, 20,
      np::point_map(CGAL::First_of_pair_property_map<Minimal_pair>())
          .normal_map(CGAL::Second_of_pair_property_map<Minimal_pair>())
          .geom_traits(Minimal_kernel()));
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const Minimal_kernel::Point_3& p = pairs[i].first;
    BOOST_REQUIRE(CGAL::squared_distance(shapes::Point_3(p.x(), p.y(), p.z()), expected[i]) <
                  1e-12);
  }
}

// ---- large numbers

BOOST_AUTO_TEST_CASE(more_than_2_to_the_32_neighbors_do_not_overflow)
{
  // 100 million points with 128 neighbors each, without the memory that they take
  typedef internal::Neighbor_graph Graph;
  const std::uint32_t last = 100000000u - 1u;
  BOOST_TEST(Graph::offset(last, 128) == std::size_t(12799999872u));
  BOOST_TEST(Graph::offset(last, 128) > std::size_t((std::numeric_limits<std::uint32_t>::max)()));
}
