// SPDX-License-Identifier: GPL-3.0-or-later
// What balanced_flow_smooth_point_set() makes of coordinates and clouds that other programs choke on.
#define BOOST_TEST_MODULE adverse_clouds
#include <boost/test/unit_test.hpp>

#include "smoothed.h"

#include <ctime>
#include <map>

namespace np = CGAL::parameters;
using shapes::noisy_cube;
using shapes::Points;
typedef CGAL::Sequential_tag Sequential;

// ---- coordinates far from 0

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

// ---- clouds that are slow where trees are not balanced, or where distances are equal

namespace {
double seconds_for(Points points)
{
  const std::clock_t start = std::clock();
  CGAL::balanced_flow_smooth_point_set<Sequential>(points, 24);
  for (const auto& p : points)
    BOOST_REQUIRE((std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z())));
  return double(std::clock() - start) / CLOCKS_PER_SEC;
}
} // namespace

BOOST_AUTO_TEST_CASE(adverse_clouds_take_no_longer_than_others)
{
  const std::size_t n = 20000;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> u(-1., 1.);
  std::normal_distribution<double> gauss(0., 1.);
  const double usual = seconds_for(noisy_cube(58)); // as many points
  const auto check = [&](const char* what, const auto& point) {
    Points points;
    for (std::size_t i = 0; i < n; ++i)
      points.push_back(point(i));
    const double seconds = seconds_for(points);
    BOOST_TEST_MESSAGE(what << ": " << seconds / usual);
    BOOST_TEST(seconds < 8. * usual, what << ": " << seconds << " s, others " << usual << " s");
  };
  typedef shapes::Point_3 P;
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
