// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers of scans tell which layers are registration error.
#ifndef POINT_SET_FLOW_TEST_LAYERS_SCAN_NUMBERS_H
#define POINT_SET_FLOW_TEST_LAYERS_SCAN_NUMBERS_H

#include "layers_two_sheets.h"

#include <boost/test/unit_test.hpp>

#include <CGAL/Point_set_3.h>
#include <CGAL/Point_set_flow/analyze_point_set.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>
#include <stdexcept>
#include <vector>

namespace layers {

using CGAL::Point_set_flow::analyze_point_set;
using CGAL::Point_set_flow::Smoothing_report;

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

/// The same ground scanned twice, with a registration error of .4 and noise of .05 of the spacing
struct Two_scans {
  Points points;
  std::vector<int> numbers;

  /// \param second the share of the points that are of the second scan
  explicit Two_scans(double second = .5)
  {
    std::mt19937 choice(9);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> u(0., 50.);
    for (int i = 0; i < 5000; ++i) {
      numbers.push_back(std::generate_canonical<double, 32>(choice) < second ? 1 : 0);
      points.emplace_back(u(random), u(random), numbers.back() == 0 ? .2 : -.2);
    }
    shapes::add_noise(points, .05);
  }

  Points smoothed_with(const std::vector<int>& scans) const
  {
    Points result = points;
    std::vector<std::size_t> indices(points.size());
    std::iota(indices.begin(), indices.end(), std::size_t(0));
    CGAL::balanced_flow_smooth_point_set<Sequential>(
        indices,
        np::scan_map(CGAL::make_property_map(scans)).point_map(CGAL::make_property_map(result)));
    return result;
  }

  /// The rms distance from the middle of the layers
  double deviation_with(const std::vector<int>& scans) const
  {
    const Points result = smoothed_with(scans);
    double sum = 0.;
    for (const auto& p : result)
      sum += p.z() * p.z();
    return std::sqrt(sum / double(result.size()));
  }
};

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

BOOST_AUTO_TEST_CASE(points_of_a_scan_with_few_points_come_to_the_others)
{
  const Two_scans scans(.08);
  const auto strays = [&](const std::vector<int>& numbers) { // rms, of the few
    const Points result = scans.smoothed_with(numbers);
    double squares = 0., count = 0.;
    for (std::size_t i = 0; i < result.size(); ++i)
      if (scans.numbers[i] == 1) {
        squares += (result[i].z() - .2) * (result[i].z() - .2);
        count += 1.;
      }
    return std::sqrt(squares / count);
  };
  BOOST_TEST(strays(scans.numbers) < .3 * .4);
  BOOST_TEST(strays(scans.numbers) < .5 * strays(std::vector<int>(scans.points.size(), 0)));
}

BOOST_AUTO_TEST_CASE(the_sides_of_a_wall_may_be_in_different_scans)
{
  const Scan wall = two_sheets(4. * sigma, -1.);
  std::vector<int> numbers(wall.size(), 0);
  std::fill(numbers.begin() + std::ptrdiff_t(wall.size() / 2), numbers.end(), 1);
  std::vector<std::size_t> indices(wall.size());
  std::iota(indices.begin(), indices.end(), std::size_t(0));
  const Smoothing_report report = analyze_point_set<Sequential>(
      indices, np::scan_map(CGAL::make_property_map(numbers))
                   .point_map(CGAL::make_property_map(wall.points))
                   .normal_map(CGAL::make_property_map(wall.normals)));
  BOOST_TEST(report.noise == sigma, boost::test_tools::tolerance(.15));
}

} // namespace layers

#endif // POINT_SET_FLOW_TEST_LAYERS_SCAN_NUMBERS_H
