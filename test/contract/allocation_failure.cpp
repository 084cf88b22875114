// SPDX-License-Identifier: GPL-3.0-or-later
// Wherever an allocation fails: nothing is changed, and nothing leaks.
#define BOOST_TEST_MODULE allocation_failure
#include <boost/test/unit_test.hpp>

#include "shapes.h"

#include <CGAL/balanced_flow_smooth_point_set.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace np = CGAL::parameters;
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
  if (std::is_same<Tag, Sequential>::value) // TBB may keep something for itself
    BOOST_REQUIRE_MESSAGE(live_allocations <= before,
                          live_allocations - before << " left after " << allocations);
  return has_ended;
}

} // namespace

BOOST_AUTO_TEST_CASE(after_any_allocation_failure_the_points_are_unchanged_and_nothing_leaks)
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
BOOST_AUTO_TEST_CASE(after_an_allocation_failure_in_a_task_the_points_are_unchanged)
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
