// SPDX-License-Identifier: GPL-3.0-or-later
// Given normals tell which layers are two sheets, and which are one surface scanned twice.
#ifndef POINT_SET_FLOW_TEST_LAYERS_GIVEN_NORMALS_H
#define POINT_SET_FLOW_TEST_LAYERS_GIVEN_NORMALS_H

#include "layers_two_sheets.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

namespace layers {

/// Not accurate, and not of unit length
inline Normals disturbed(Normals normals)
{
  std::mt19937 random(8);
  std::normal_distribution<double> gauss(0., .3);
  for (auto& n : normals)
    n = (n + shapes::Vector_3(gauss(random), gauss(random), gauss(random))) *
        std::exp(10. * gauss(random));
  return normals;
}

BOOST_AUTO_TEST_CASE(sheets_with_opposite_normals_stay_apart)
{
  for (const double separation : {1.5 * sigma, 3. * sigma, 6. * sigma}) {
    const Scan scan = two_sheets(separation, -1.);
    const Points result = scan.smoothed(scan.normals);
    BOOST_TEST(approach(scan, result, separation) < .2);
    BOOST_TEST(deviation(scan, result) < .6 * sigma);
    BOOST_TEST(approach(scan, scan.smoothed(disturbed(scan.normals)), separation) < .2);
  }
}

BOOST_AUTO_TEST_CASE(normals_into_the_wall_and_out_of_it_give_the_same_points)
{
  const Scan scan = two_sheets(2. * sigma, -1.);
  const Points expected = scan.smoothed(scan.normals);
  BOOST_TEST((scan.smoothed(turned(scan.normals)) == expected));

  // of any length
  for (const double length : {std::ldexp(1., 1000), std::ldexp(1., -1060)}) {
    Normals scaled = scan.normals;
    for (auto& n : scaled)
      n = length * n;
    BOOST_TEST((scan.smoothed(scaled) == expected));
  }
}

BOOST_AUTO_TEST_CASE(layers_with_normals_on_the_same_side_come_together)
{
  const double separation = 1.5 * sigma;
  const Scan scan = two_sheets(separation, 1.);
  const Points result = scan.smoothed(scan.normals);
  double distance = 0.;
  const std::size_t half = scan.size() / 2;
  for (std::size_t i = 0; i < half; ++i)
    distance += (result[half + i].z() - result[i].z()) / double(half);
  BOOST_TEST(distance < .5 * separation);
}

BOOST_AUTO_TEST_CASE(few_wrong_normals_are_recognized)
{
  const double separation = 1.5 * sigma;
  const Scan scan = two_sheets(separation, 1.);
  Normals some_wrong = scan.normals;
  for (std::size_t i = 0; i < some_wrong.size(); i += 30)
    some_wrong[i] = -some_wrong[i];
  const auto height_of = [&](const Points& result) { // rms, in the middle
    return std::sqrt(scan.mean(
        result, true, [](const shapes::Point_3& p, std::size_t) { return p.z() * p.z(); }));
  };
  const double right = height_of(scan.smoothed(scan.normals));
  BOOST_TEST(height_of(scan.smoothed(some_wrong)) < 1.15 * right);
  BOOST_TEST(height_of(scan.smoothed_without_normals()) > 1.3 * right);
}

BOOST_AUTO_TEST_CASE(null_normals_say_nothing)
{
  const Scan scan = two_sheets(2. * sigma, -1.);
  const Points expected = scan.smoothed_without_normals();
  BOOST_TEST((scan.smoothed(Normals(scan.size(), unknown)) == expected));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  BOOST_TEST((scan.smoothed(Normals(scan.size(), shapes::Vector_3(0., nan, 1.))) == expected));
  BOOST_TEST((scan.smoothed(scan.normals) != expected));

  // some of them
  Normals some = scan.normals;
  for (std::size_t i = 0; i < some.size(); i += 4)
    some[i] = unknown;
  BOOST_TEST(approach(scan, scan.smoothed(some), 2. * sigma) < .6);
}

BOOST_AUTO_TEST_CASE(random_orientations_are_recognized)
{
  for (const double separation : {0., 2. * sigma}) {
    const Scan scan = two_sheets(separation, -1.);
    const Points expected = scan.smoothed_without_normals();
    const Points result = scan.smoothed(at_random(scan.normals));
    double squares = 0.;
    for (std::size_t i = 0; i < result.size(); ++i)
      squares += CGAL::squared_distance(result[i], expected[i]) / double(result.size());
    BOOST_TEST(std::sqrt(squares) < .1 * sigma);
  }
}

BOOST_AUTO_TEST_CASE(points_on_the_opposite_side_do_not_attract)
{
  // a few points above a sheet, with the opposite side: no matter where they are, the sheet stays the same
  const Scan sheet = two_sheets(0., 1.);
  std::vector<double> heights;
  for (const double height : {2. * sigma, 4. * sigma}) {
    Scan scan = sheet;
    for (std::size_t i = 0; i < sheet.size(); i += 2) {
      scan.points.push_back(sheet.truth[i] + shapes::Vector_3(0., 0., height));
      scan.truth.push_back(scan.points.back());
      scan.normals.emplace_back(0., 0., -1.);
    }
    const Points result = scan.smoothed(turned(scan.normals));
    heights.push_back(scan.mean(result, true, [](const auto& p, std::size_t) { return p.z(); }));
  }
  BOOST_TEST(std::abs(heights[0]) < .1 * sigma);
  BOOST_TEST(std::abs(heights[1]) < .1 * sigma);
}

BOOST_AUTO_TEST_CASE(results_do_not_depend_on_order_threads_and_blocks)
{
  Scan scan = two_sheets(2. * sigma, -1.);
  for (std::size_t i = 0; i < 100; ++i) { // duplicates, with the same side, another one, or none
    scan.points.push_back(scan.points[i]);
    scan.normals.push_back(i % 3 == 0   ? unknown
                           : i % 3 == 1 ? -scan.normals[i]
                                        : scan.normals[i] + shapes::Vector_3(.1, .2, .3));
  }
  const Points expected = scan.smoothed(scan.normals);
  for (const unsigned int block_size : {1000u, 3000u})
    BOOST_TEST((scan.smoothed(scan.normals, block_size) == expected));
  BOOST_TEST((scan.smoothed<CGAL::Parallel_if_available_tag>(scan.normals) == expected));
  BOOST_TEST((scan.smoothed(turned(scan.normals)) == expected));

  std::vector<std::size_t> order(scan.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::shuffle(order.begin(), order.end(), std::mt19937(5));
  Scan shuffled;
  for (const std::size_t i : order) {
    shuffled.points.push_back(scan.points[i]);
    shuffled.normals.push_back(scan.normals[i]);
  }
  const Points result = shuffled.smoothed(shuffled.normals);
  for (std::size_t i = 0; i < order.size(); ++i)
    BOOST_REQUIRE((result[i] == expected[order[i]]));
}

} // namespace layers

#endif // POINT_SET_FLOW_TEST_LAYERS_GIVEN_NORMALS_H
