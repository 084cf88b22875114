// SPDX-License-Identifier: GPL-3.0-or-later
// Degenerate point sets, extreme coordinates, and clouds that are slow elsewhere.
#define BOOST_TEST_MODULE extreme_input
#include <boost/test/unit_test.hpp>

#include "smoothed.h"

#include <map>

namespace np = CGAL::parameters;
using namespace CGAL::Point_set_flow;
using shapes::largest_difference;
using shapes::noisy_cube;
using shapes::Points;
using shapes::smoothed;
typedef CGAL::Sequential_tag Sequential;

// ---- degenerate point sets

BOOST_AUTO_TEST_CASE(few_identical_or_collinear_points_give_finite_points)
{
  Points none;
  BOOST_TEST(CGAL::balanced_flow_smooth_point_set<Sequential>(none, 20) == 0.);
  BOOST_TEST(CGAL::balanced_flow_smooth_point_set<Sequential>(none) == 0.);

  Points few = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  while (!few.empty()) { // three points or fewer lie in a plane
    Points points = few;
    BOOST_TEST(CGAL::balanced_flow_smooth_point_set<Sequential>(points) < 1e-12);
    BOOST_TEST(largest_difference(points, few) < 1e-12);
    few.pop_back();
  }
  const auto check_finite = [](Points points) {
    BOOST_TEST(std::isfinite(CGAL::balanced_flow_smooth_point_set<Sequential>(points)));
    for (const auto& p : points)
      BOOST_REQUIRE((std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z())));
  };
  check_finite(Points(1000, shapes::Point_3(1, 2, 3)));
  check_finite(shapes::sphere(7, 1.)); // fewer than k
  Points line;
  for (int i = 0; i < 100; ++i)
    line.emplace_back(i, 2. * i, -i);
  check_finite(line);
  line.emplace_back(1e12, 1e12, 1e12);
  check_finite(line);
}

BOOST_AUTO_TEST_CASE(a_point_alone_keeps_its_normal)
{
  typedef std::pair<shapes::Point_3, shapes::Vector_3> Pair;
  std::vector<Pair> pairs;
  for (const auto& p : noisy_cube(6))
    pairs.emplace_back(p, CGAL::NULL_VECTOR);
  pairs.emplace_back(shapes::Point_3(50, 0, 0), shapes::Vector_3(3, 0, 0));
  CGAL::balanced_flow_smooth_point_set<Sequential>(
      pairs, 20,
      np::neighbor_radius(1.)
          .point_map(CGAL::First_of_pair_property_map<Pair>())
          .normal_map(CGAL::Second_of_pair_property_map<Pair>()));
  BOOST_TEST((pairs.back() == Pair(shapes::Point_3(50, 0, 0), shapes::Vector_3(1, 0, 0))));
}

BOOST_AUTO_TEST_CASE(a_start_in_one_place_is_as_fast_as_another)
{
  typedef std::pair<shapes::Point_3, shapes::Point_3> Pair;
  std::vector<Pair> pairs;
  for (const auto& p : noisy_cube(40))
    pairs.emplace_back(p, CGAL::ORIGIN);
  CGAL::balanced_flow_smooth_point_set<Sequential>(
      pairs, 20,
      np::flow(Volume_preserving_flow())
          .update_period(0)
          .initial_point_map(CGAL::Second_of_pair_property_map<Pair>())
          .number_of_iterations(20)
          .point_map(CGAL::First_of_pair_property_map<Pair>()));
  double mean = 0.;
  for (const auto& pair : pairs)
    mean += shapes::distance_to_cube(pair.first) / double(pairs.size());
  BOOST_TEST(mean < .05); // back at the reference
}

// ---- extreme coordinates

BOOST_AUTO_TEST_CASE(georeferenced_points_keep_their_millimeters)
{
  // meters; the noise is 2 cm
  const Points noisy = noisy_cube(), expected = smoothed(noisy);
  const shapes::Vector_3 offset(4.5e5, 5.4e6, 100.);
  Points points;
  for (const auto& p : noisy)
    points.push_back(p + offset);
  points = smoothed(points);
  for (std::size_t i = 0; i < points.size(); ++i)
    BOOST_REQUIRE(CGAL::squared_distance(points[i] - offset, expected[i]) < 1e-12);
}

BOOST_AUTO_TEST_CASE(georeferenced_floats_move_no_farther_than_their_neighbors)
{
  // what is left of the coordinates are half meters, and many points are duplicates
  typedef CGAL::Simple_cartesian<float>::Point_3 Float_point;
  std::vector<Float_point> noisy;
  for (const auto& p : noisy_cube(20))
    noisy.emplace_back(float(4.5e5 + 10. * p.x()), float(5.4e6 + 10. * p.y()), float(10. * p.z()));
  std::vector<Float_point> points = noisy;
  CGAL::balanced_flow_smooth_point_set<Sequential>(points, 20);
  std::map<Float_point, Float_point> became;
  for (std::size_t i = 0; i < points.size(); ++i) {
    BOOST_REQUIRE(CGAL::squared_distance(points[i], noisy[i]) < 9.f);
    BOOST_REQUIRE((became.emplace(noisy[i], points[i]).first->second == points[i]));
  }
}

BOOST_AUTO_TEST_CASE(the_largest_coordinates_stay_finite)
{
  const auto check = [](auto number) {
    typedef decltype(number) FT;
    typedef typename CGAL::Simple_cartesian<FT>::Point_3 Point;
    const FT largest = (std::numeric_limits<FT>::max)();
    for (unsigned int seed = 1; seed <= 20; ++seed) {
      std::mt19937 random(seed);
      std::uniform_real_distribution<FT> c(FT(.9), FT(1.));
      std::vector<Point> points;
      for (int i = 0; i < 50; ++i)
        points.emplace_back(c(random) * largest, i % 2 ? largest : -largest, c(random) * largest);
      CGAL::balanced_flow_smooth_point_set<Sequential>(points, 20);
      for (const Point& p : points)
        BOOST_REQUIRE((std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z())));
    }
  };
  check(1.f);
  check(1.);
}

BOOST_AUTO_TEST_CASE(a_radius_too_small_to_be_squared_is_a_radius)
{
  Points noisy;
  for (const auto& p : noisy_cube(6))
    noisy.emplace_back(1e200 * p.x(), 1e200 * p.y(), 1e200 * p.z());
  for (const double radius : {1e-200, 1e-320, 1e190}) {
    Points points = noisy;
    CGAL::balanced_flow_smooth_point_set<Sequential>(points, 20, np::neighbor_radius(radius));
    BOOST_TEST((points == noisy));
  }
}

BOOST_AUTO_TEST_CASE(a_point_far_away_does_not_disturb_the_others)
{
  // sentinels of scanners are finite
  const Points noisy = noisy_cube(), expected = smoothed(noisy);
  for (const double far : {1e12, 1e20, 3.4e38, 1e100}) {
    Points points = noisy;
    points.emplace_back(far, 0., 0.);
    points = smoothed(points);
    BOOST_TEST(std::isfinite(points.back().x()));
    points.pop_back();
    double sum = 0.;
    for (std::size_t i = 0; i < noisy.size(); ++i)
      sum += CGAL::squared_distance(points[i], expected[i]);
    // the noise is sampled elsewhere; a point beside an edge may come to its other side
    BOOST_TEST(std::sqrt(sum / double(noisy.size())) < .002);
  }
}

// ---- clouds for which trees are not balanced, or distances are equal

// Scanners write pixels without a measurement as 0 0 0.
BOOST_AUTO_TEST_CASE(copies_far_from_everything_stay_where_they_are)
{
  Points points = noisy_cube(40);
  for (shapes::Point_3& p : points)
    p = p + shapes::Vector_3(30., 20., 10.);
  const std::size_t surface = points.size(), copies = 1000;
  points.insert(points.end(), copies, shapes::Point_3(0., 0., 0.));
  const Points before = points;
  CGAL::Point_set_flow::Smoothing_report report;
  CGAL::balanced_flow_smooth_point_set<CGAL::Sequential_tag>(
      points, CGAL::parameters::smoothing_report(std::ref(report)));
  for (std::size_t i = surface; i < points.size(); ++i)
    BOOST_REQUIRE((points[i] == before[i]));
  BOOST_TEST(report.number_of_isolated_points == copies);
  BOOST_TEST(report.number_of_moved_points > surface * 9 / 10);
}

// How long these take is measured by `benchmark_speed --difficult`.
BOOST_AUTO_TEST_CASE(adverse_clouds_stay_finite)
{
  typedef shapes::Point_3 P;
  const std::size_t n = 20000;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> u(-1., 1.);
  std::normal_distribution<double> gauss(0., 1.);
  const auto check = [&](const char* what, const auto& point) {
    Points points;
    for (std::size_t i = 0; i < n; ++i)
      points.push_back(point(i));
    BOOST_TEST_CONTEXT(what)
    {
      CGAL::balanced_flow_smooth_point_set<Sequential>(points, 24);
      for (const P& p : points)
        BOOST_REQUIRE((std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z())));
    }
  };
  for (const double far : {1e3, -1e3, 1e9}) // a plane along two axes, and one point far from it
    check("plane and point",
          [&](std::size_t i) { return P(i == 7 ? far : 0., u(random), u(random)); });
  check("plane and points", [&](std::size_t i) {
    return P(i % 3 == 0 ? 1e3 * std::abs(gauss(random)) : 0., u(random), u(random));
  });
  for (const double decades : {20., 300.}) // of all sizes
    check("magnitudes", [&](std::size_t) {
      const double size = std::pow(10., decades * u(random));
      return P(size * u(random), size * u(random), size * u(random));
    });
  check("clusters",
        [&](std::size_t i) { return P(i % 2 == 0 ? 1e12 : u(random), u(random), gauss(random)); });
  check("many clusters", [&](std::size_t i) {
    return P(1e9 * double(i % 100) + 1e-3 * u(random), u(random), 1e-3 * gauss(random));
  });
  check("lattice",
        [&](std::size_t i) { return P(double(i % 27), double(i / 27 % 27), double(i / 729)); });
  check("line of duplicates", [&](std::size_t i) { return P(double(i / 4), double(i / 4), 0.); });
  check("circle", [&](std::size_t i) {
    return i == 0 ? P(0., 0., 0.) : P(std::cos(double(i)), std::sin(double(i)), 0.);
  });
  check("identical points", [&](std::size_t) { return P(1., 2., 3.); });
}
