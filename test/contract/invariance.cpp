// SPDX-License-Identifier: GPL-3.0-or-later
// What the result does not depend on: threads, blocks, the order of the points, where they are.
#define BOOST_TEST_MODULE invariance
#include <boost/test/unit_test.hpp>

#include "smoothed.h"

#include <CGAL/Aff_transformation_3.h>

#include <numeric>
#include <tuple>

namespace np = CGAL::parameters;
using namespace CGAL::Point_set_flow;
using shapes::largest_difference;
using shapes::noisy_cube;
using shapes::Points;
using shapes::smoothed;
typedef CGAL::Sequential_tag Sequential;

BOOST_AUTO_TEST_CASE(parallel_and_sequential_results_are_bitwise_identical)
{
#ifdef CGAL_LINKED_WITH_TBB
  Points noisy = noisy_cube(60);
  noisy.insert(noisy.end(), noisy.begin(), noisy.begin() + 1000); // duplicates
  Points sequential = noisy, parallel = noisy;
  const double a = CGAL::balanced_flow_smooth_point_set<Sequential>(sequential);
  const double b = CGAL::balanced_flow_smooth_point_set<CGAL::Parallel_tag>(parallel);
  BOOST_TEST(a == b);
  BOOST_TEST((sequential == parallel));
  BOOST_TEST(a > 0.);

  // the same with all that can be passed
  const auto run = [&](auto tag, const auto& flow) {
    typedef std::tuple<shapes::Point_3, shapes::Vector_3, shapes::Point_3, bool> Item;
    std::vector<Item> items;
    for (std::size_t i = 0; i < noisy.size(); ++i)
      items.emplace_back(noisy[i], CGAL::NULL_VECTOR, noisy[i] + shapes::Vector_3(.01, 0., 0.),
                         i % 5 == 0);
    const double moved = CGAL::balanced_flow_smooth_point_set<decltype(tag)>(
        items, np::flow(flow)
                   .initial_point_map(CGAL::Nth_of_tuple_property_map<2, Item>())
                   .point_map(CGAL::Nth_of_tuple_property_map<0, Item>())
                   .normal_map(CGAL::Nth_of_tuple_property_map<1, Item>())
                   .point_is_constrained_map(CGAL::Nth_of_tuple_property_map<3, Item>()));
    for (std::size_t i = 0; i < noisy.size(); i += 5)
      BOOST_REQUIRE((std::get<0>(items[i]) == noisy[i])); // constrained, wherever others start
    return std::make_pair(items, moved);
  };
  BOOST_TEST((run(Sequential(), Balanced_flow()) == run(CGAL::Parallel_tag(), Balanced_flow())));
  BOOST_TEST((run(Sequential(), Curvature_flow()) == run(CGAL::Parallel_tag(), Curvature_flow())));
#endif
}

BOOST_AUTO_TEST_CASE(results_in_several_blocks_and_in_one_are_bitwise_identical)
{
  const Points noisy = noisy_cube(60);
  const auto run = [&](unsigned int block_size, const auto& curvature, unsigned int steps) {
    std::vector<std::pair<shapes::Point_3, shapes::Vector_3>> pairs;
    for (const auto& p : noisy)
      pairs.emplace_back(p, shapes::Vector_3(0, 0, 0));
    typedef std::pair<shapes::Point_3, shapes::Vector_3> Pair;
    const double moved = CGAL::balanced_flow_smooth_point_set<Sequential>(
        pairs, np::block_size(block_size)
                   .curvature(curvature)
                   .number_of_iterations(steps)
                   .point_map(CGAL::First_of_pair_property_map<Pair>())
                   .normal_map(CGAL::Second_of_pair_property_map<Pair>()));
    return std::make_pair(pairs, moved);
  };
  const auto check = [&](const auto& curvature, unsigned int steps) {
    const auto whole = run(1000000, curvature, steps);
    for (const unsigned int block_size : {1u, 3000u, 20000u})
      BOOST_TEST((run(block_size, curvature, steps) == whole));
  };
  check(Tangent_plane_curvature(), 2);
  check(Covariance_curvature(), 3);
}

BOOST_AUTO_TEST_CASE(the_result_does_not_depend_on_the_order_of_the_input)
{
  Points noisy = noisy_cube(), automatic = noisy;
  for (int i = 0; i < 50; ++i)
    noisy.push_back(noisy[std::size_t(i)]);
  const Points expected = smoothed(noisy);
  for (std::size_t i = 0; i < 50; ++i) // duplicates stay together
    BOOST_REQUIRE((expected[i] == expected[noisy.size() - 50 + i]));

  std::vector<std::size_t> order(noisy.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::shuffle(order.begin(), order.end(), std::mt19937(11));
  Points shuffled;
  for (const std::size_t i : order)
    shuffled.push_back(noisy[i]);
  const Points result = smoothed(shuffled);
  for (std::size_t i = 0; i < order.size(); ++i)
    BOOST_REQUIRE((result[i] == expected[order[i]]));
}

BOOST_AUTO_TEST_CASE(the_result_is_translated_scaled_and_rotated_with_the_points)
{
  const Points noisy = noisy_cube();
  Points expected = noisy;
  CGAL::balanced_flow_smooth_point_set<Sequential>(expected); // k from the data
  const auto check = [&](const auto& transform, double tolerance) {
    Points points, reference;
    for (const auto& p : noisy)
      points.push_back(transform(p));
    for (const auto& p : expected)
      reference.push_back(transform(p));
    CGAL::balanced_flow_smooth_point_set<Sequential>(points);
    BOOST_TEST(largest_difference(points, reference) < tolerance);
  };
  typedef CGAL::Aff_transformation_3<shapes::Kernel> Transformation;
  check(Transformation(CGAL::TRANSLATION, shapes::Vector_3(1e7, -1e7, 1e7)), 1e-6);
  check(Transformation(CGAL::SCALING, 1e-6), 1e-6 * 1e-7);
  check(Transformation(CGAL::SCALING, 1e6), 1e6 * 1e-7);
  check(Transformation(CGAL::SCALING, 1e-150), 1e-150 * 1e-7);
  check(Transformation(CGAL::SCALING, 1e150), 1e150 * 1e-7);
  // differences from neighbors, and sums over them, are in single precision, and rounded otherwise
  const double c = std::cos(.6), s = std::sin(.6);
  check(Transformation(c, -s, 0., s, c, 0., 0., 0., 1.), 3e-6);
  check(Transformation(1., 0., 0., 0., c, -s, 0., s, c), 3e-6);
}

namespace {

/// Hilly ground of unit spacing, jittered, with noise of .3 from x = 0 on; the noise before is given
Points ground(double least_x, double most_x, double noise_before)
{
  Points points;
  for (int i = -100; i < 400; ++i)
    for (int j = 0; j < 30; ++j) {
      std::mt19937 random(unsigned(1000 * (i + 100) + j)); // the same at any place
      std::normal_distribution<double> gauss(0., 1.);
      const double x = i + .2 * gauss(random), y = j + .2 * gauss(random);
      const double noise = (i < 0 ? noise_before : .3) * gauss(random);
      if (x >= least_x && x < most_x)
        points.emplace_back(x, y, 2. * std::sin(.1 * x) * std::cos(.15 * y) + noise);
    }
  return points;
}

} // namespace

// The result at a point is a function of the points around it: nothing is decided for all points.
BOOST_AUTO_TEST_CASE(the_result_depends_on_the_points_around_only)
{
  const Points all = smoothed(ground(-100., 400., .3));
  const Points cut = smoothed(ground(-100., 250., .3));     // without a part far away
  const Points noisier = smoothed(ground(-100., 400., 2.)); // with noise of another kind there
  const Points none = smoothed(ground(0., 400., .3));
  const auto compare = [&](const Points& other, double least_x, double most_x) {
    std::size_t compared = 0;
    for (const auto& p : other)
      if (p.x() > least_x && p.x() < most_x) {
        const auto nearest =
            *std::min_element(all.begin(), all.end(), [&](const auto& a, const auto& b) {
              return CGAL::squared_distance(a, p) < CGAL::squared_distance(b, p);
            });
        BOOST_REQUIRE(CGAL::squared_distance(nearest, p) < 1e-20); // they are moved to the origin
        ++compared;
      }
    BOOST_TEST(compared > 1000u);
  };
  compare(cut, -100., 120.);
  compare(noisier, 140., 400.);
  compare(none, 140., 400.);
}
