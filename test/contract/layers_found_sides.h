// SPDX-License-Identifier: GPL-3.0-or-later
// Where no normals tell the sides of two sheets, they are found.
#ifndef POINT_SET_FLOW_TEST_LAYERS_FOUND_SIDES_H
#define POINT_SET_FLOW_TEST_LAYERS_FOUND_SIDES_H

#include "layers_two_sheets.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <random>

namespace layers {

const double strong = 2. * sigma;

inline Scan noisy_wall(unsigned int seed) { return two_sheets(5. * strong, -1., seed, strong); }

BOOST_AUTO_TEST_CASE(sheets_are_told_apart_without_normals)
{
  // neighborhoods are wider than the wall is thick
  for (const unsigned int seed : {1u, 2u}) {
    const Scan scan = noisy_wall(seed);
    const Points result = scan.smoothed_without_normals();
    BOOST_TEST(approach(scan, result, 5. * strong) < .1);
    BOOST_TEST(deviation(scan, result) < .7 * strong);
    BOOST_TEST(deviation(scan, scan.smoothed(at_random(scan.normals))) < .7 * strong);
  }
}

BOOST_AUTO_TEST_CASE(one_sheet_is_not_taken_for_two)
{
  for (const bool is_uniform : {false, true}) { // which is as flat as two sheets are
    Scan scan = two_sheets(0., -1.);
    if (is_uniform) {
      std::mt19937 random(4);
      std::uniform_real_distribution<double> uniform(-std::sqrt(3.) * sigma, std::sqrt(3.) * sigma);
      scan.points = scan.truth;
      for (auto& p : scan.points)
        p += shapes::Vector_3(0., 0., uniform(random));
    }
    // uniform noise that is wider than the spacing is taken for two sheets by the learned estimator
    BOOST_TEST(deviation(scan, scan.smoothed_without_normals()) < (is_uniform ? .9 : .3) * sigma);
  }
}

BOOST_AUTO_TEST_CASE(sides_that_are_found_do_not_contradict_given_ones)
{
  const Scan scan = noisy_wall(1);
  Normals some = scan.normals;
  for (std::size_t i = 0; i < some.size(); i += 2)
    some[i] = unknown;
  BOOST_TEST((scan.smoothed(turned(some)) == scan.smoothed(some)));
}

BOOST_AUTO_TEST_CASE(sides_that_are_found_do_not_depend_on_blocks)
{
  const Scan scan = noisy_wall(1);
  const Points expected = scan.smoothed_without_normals();
  for (const unsigned int block_size : {1000u, 3000u})
    BOOST_TEST((scan.smoothed(Normals(scan.size(), unknown), block_size) == expected));
}

} // namespace layers

#endif // POINT_SET_FLOW_TEST_LAYERS_FOUND_SIDES_H
