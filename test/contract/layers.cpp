// SPDX-License-Identifier: GPL-3.0-or-later
// Layers: given normals tell which of them are two sheets, and which are one surface scanned twice.
#define BOOST_TEST_MODULE layers
#include <boost/test/unit_test.hpp>

#include "shapes.h"

#include <CGAL/Point_set_3.h>
#include <CGAL/Point_set_flow/analyze_point_set.h>
#include <CGAL/balanced_flow_smooth_point_set.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <random>
#include <utility>

namespace np = CGAL::parameters;
using namespace CGAL::Point_set_flow;
using shapes::Points;
typedef CGAL::Sequential_tag Sequential;
typedef std::vector<shapes::Vector_3> Normals;

namespace {

const shapes::Vector_3 unknown(0., 0., 0.);

/// Points with normals that are given, and where they would be without noise
struct Scan {
  Points points, truth;
  Normals normals;

  std::size_t size() const { return points.size(); }

  template <typename Tag = Sequential>
  Points smoothed(Normals given, unsigned int block_size = 1000000) const
  {
    Points result = points;
    std::vector<std::size_t> indices(size());
    std::iota(indices.begin(), indices.end(), std::size_t(0));
    CGAL::balanced_flow_smooth_point_set<Tag>(indices,
                                              np::block_size(block_size)
                                                  .point_map(CGAL::make_property_map(result))
                                                  .normal_map(CGAL::make_property_map(given)));
    return result;
  }

  Points smoothed_without_normals() const
  {
    Points result = points;
    CGAL::balanced_flow_smooth_point_set<Sequential>(result);
    return result;
  }

  /// The mean of a function of a point and its number, over points of one layer and far from the border
  template <typename Function>
  double mean(const Points& result, bool is_up, const Function& function) const
  {
    double sum = 0., count = 0.;
    for (std::size_t i = 0; i < size(); ++i)
      if ((normals[i].z() > 0.) == is_up && std::abs(truth[i].x()) < .7 &&
          std::abs(truth[i].y()) < .7) {
        sum += function(result[i], i);
        count += 1.;
      }
    return sum / count;
  }
};

const double sigma = .02; // half of the spacing of a sheet

/// Two square sheets, one above the other
/// \param side of the lower one; that of the upper one is 1
Scan two_sheets(double separation, double side, unsigned int seed = 1, double noise = sigma)
{
  Scan scan;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> jitter(.1, .9);
  const int m = 50;
  for (const double sign : {-1., 1.})
    for (int i = 0; i < m; ++i)
      for (int j = 0; j < m; ++j) {
        const double x = 2. * (i + jitter(random)) / m - 1., y = 2. * (j + jitter(random)) / m - 1.;
        scan.truth.emplace_back(x, y, .5 * sign * separation);
        scan.normals.emplace_back(0., 0., sign > 0. ? 1. : side);
      }
  scan.points = scan.truth;
  shapes::add_noise(scan.points, noise, seed);
  return scan;
}

const double strong = 2. * sigma;

Scan noisy_wall(unsigned int seed) { return two_sheets(5. * strong, -1., seed, strong); }

Normals turned(Normals normals)
{
  for (auto& n : normals)
    n = -n;
  return normals;
}

Normals at_random(Normals normals)
{
  std::mt19937 random(7);
  for (auto& n : normals)
    if (random() % 2)
      n = -n;
  return normals;
}

/// Not accurate, and not of unit length
Normals disturbed(Normals normals)
{
  std::mt19937 random(8);
  std::normal_distribution<double> gauss(0., .3);
  for (auto& n : normals)
    n = (n + shapes::Vector_3(gauss(random), gauss(random), gauss(random))) *
        std::exp(10. * gauss(random));
  return normals;
}

/// How far the mean of each sheet is from where it should be, as a share of the separation
double approach(const Scan& scan, const Points& result, double separation)
{
  const auto error = [&](const shapes::Point_3& p, std::size_t i) {
    return p.z() - scan.truth[i].z();
  };
  return (std::max)(std::abs(scan.mean(result, true, error)),
                    std::abs(scan.mean(result, false, error))) /
         separation;
}

double deviation(const Scan& scan, const Points& result)
{
  const auto squared = [&](const shapes::Point_3& p, std::size_t i) {
    return (p.z() - scan.truth[i].z()) * (p.z() - scan.truth[i].z());
  };
  return std::sqrt(.5 * (scan.mean(result, true, squared) + scan.mean(result, false, squared)));
}

} // namespace

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
    BOOST_TEST(deviation(scan, scan.smoothed_without_normals()) < (is_uniform ? .6 : .3) * sigma);
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
  BOOST_TEST(approach(scan, scan.smoothed(some), 2. * sigma) <
             approach(scan, expected, 2. * sigma));
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

BOOST_AUTO_TEST_CASE(sides_that_are_found_do_not_depend_on_blocks)
{
  const Scan scan = noisy_wall(1);
  const Points expected = scan.smoothed_without_normals();
  for (const unsigned int block_size : {1000u, 3000u})
    BOOST_TEST((scan.smoothed(Normals(scan.size(), unknown), block_size) == expected));
}

BOOST_AUTO_TEST_CASE(numbers_of_scans_of_any_integer_type_are_read)
{
  const Scan scan = two_sheets(2. * sigma, -1.);
  const auto smoothed = [&](auto numbers) {
    Points result = scan.points;
    std::vector<std::size_t> indices(scan.size());
    std::iota(indices.begin(), indices.end(), std::size_t(0));
    for (std::size_t i = 0; i < numbers.size(); ++i)
      numbers[i] = typename decltype(numbers)::value_type(2 * i / numbers.size());
    CGAL::balanced_flow_smooth_point_set<Sequential>(
        indices,
        np::scan_map(CGAL::make_property_map(numbers)).point_map(CGAL::make_property_map(result)));
    const Smoothing_report report = analyze_point_set<Sequential>(
        indices, np::scan_map(CGAL::make_property_map(numbers))
                     .point_map(CGAL::make_property_map(scan.points)));
    BOOST_TEST(report.number_of_points == scan.size());
    return result;
  };
  const Points expected = smoothed(std::vector<std::uint32_t>(scan.size()));
  BOOST_TEST((smoothed(std::vector<unsigned char>(scan.size())) == expected));
  BOOST_TEST((smoothed(std::vector<int>(scan.size())) == expected));
  BOOST_TEST((smoothed(std::vector<std::int64_t>(scan.size())) == expected));
}

BOOST_AUTO_TEST_CASE(constant_point_sets_with_normals_are_analyzed)
{
  typedef CGAL::Point_set_3<shapes::Point_3> Point_set;
  const Scan scan = two_sheets(2. * sigma, -1.);
  Point_set points;
  points.add_normal_map();
  auto scans = points.add_property_map<unsigned char>("scan", 0).first;
  for (std::size_t i = 0; i < scan.size(); ++i)
    points.insert(scan.points[i], scan.normals[i]);
  const Point_set& constant = points;
  const Smoothing_report own = analyze_point_set<Sequential>(constant);
  const Smoothing_report named = analyze_point_set<Sequential>(
      constant, np::scan_map(scans).point_map(points.point_map()).normal_map(points.normal_map()));
  BOOST_TEST(own.number_of_points == scan.size());
  BOOST_TEST(named.number_of_points == scan.size());

  Point_set by_range = points;
  CGAL::balanced_flow_smooth_point_set<Sequential>(by_range);
  const Points expected = scan.smoothed(scan.normals);
  std::size_t i = 0;
  for (const auto& index : by_range)
    BOOST_REQUIRE((by_range.point(index) == expected[i++]));

  // a map made for fewer points
  Point_set fewer;
  fewer.insert(scan.points[0]);
  const auto few_scans = fewer.add_property_map<unsigned char>("scan", 0).first;
  BOOST_CHECK_THROW(analyze_point_set<Sequential>(constant, np::scan_map(few_scans)),
                    std::invalid_argument);
}

namespace {

/// The same ground scanned twice, with a registration error of .4 and noise of .05 of the spacing
struct Two_scans {
  Points points;
  std::vector<int> numbers;

  Two_scans()
  {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> u(0., 50.);
    for (int i = 0; i < 5000; ++i) {
      points.emplace_back(u(random), u(random), i % 2 == 0 ? .2 : -.2);
      numbers.push_back(i % 2);
    }
    shapes::add_noise(points, .05);
  }

  /// The rms distance from the middle of the layers
  double deviation_with(const std::vector<int>& scans) const
  {
    Points result = points;
    std::vector<std::size_t> indices(points.size());
    std::iota(indices.begin(), indices.end(), std::size_t(0));
    CGAL::balanced_flow_smooth_point_set<Sequential>(
        indices,
        np::scan_map(CGAL::make_property_map(scans)).point_map(CGAL::make_property_map(result)));
    double sum = 0.;
    for (const auto& p : result)
      sum += p.z() * p.z();
    return std::sqrt(sum / double(result.size()));
  }
};

} // namespace

BOOST_AUTO_TEST_CASE(layers_of_different_scans_come_together)
{
  const Two_scans scans;
  const double known = scans.deviation_with(scans.numbers);
  const double unknown_scans = scans.deviation_with(std::vector<int>(scans.points.size(), 3));
  std::vector<int> shuffled = scans.numbers; // tell nothing on the heights
  std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937(3));
  BOOST_TEST(known < .4 * .2);
  BOOST_TEST(known < .5 * unknown_scans);
  BOOST_TEST(scans.deviation_with(shuffled) == unknown_scans, boost::test_tools::tolerance(.1));
}
