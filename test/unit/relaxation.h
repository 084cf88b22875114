// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_TEST_RELAXATION_H
#define CGAL_POINT_SET_FLOW_TEST_RELAXATION_H

#include "shapes.h"

#include <CGAL/balanced_flow_smooth_point_set.h>

#include <boost/test/unit_test.hpp>

#include <functional>
#include <numeric>

// Points that are moved along the surface, too: what becomes more even, and what stays.
namespace relaxation {

using shapes::Point_3;
using shapes::Points;

/// \param steps 0: not moved along the surface
/// \param constrained empty if no point is
inline Points smoothed(Points points, unsigned int steps, std::vector<char> constrained = {})
{
  namespace np = CGAL::parameters;
  constrained.resize(points.size());
  std::vector<std::size_t> indices(points.size());
  std::iota(indices.begin(), indices.end(), std::size_t(0));
  CGAL::balanced_flow_smooth_point_set<CGAL::Parallel_if_available_tag>(
      indices, np::number_of_relaxation_steps(steps)
                   .point_map(CGAL::make_property_map(points))
                   .point_is_constrained_map(CGAL::make_property_map(constrained)));
  return points;
}

/// m times m points of unit spacing in the plane z = 0, each moved within it
inline Points patch(int m, double jitter, unsigned int seed = 1)
{
  Points points;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1., 1.);
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < m; ++j) {
      const double x = i + jitter * unit(random), y = j + jitter * unit(random);
      points.emplace_back(x, y, 0.);
    }
  return points;
}

inline double nearest_distance(const Points& points, const Point_3& from, std::size_t but_not)
{
  double least = 1e300;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (i != but_not)
      least = (std::min)(least, CGAL::squared_distance(points[i], from));
  return std::sqrt(least);
}

/// The standard deviation of the distances to the nearest other point, as a share of their mean
inline double unevenness(const Points& points)
{
  double sum = 0., squares = 0.;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double d = nearest_distance(points, points[i], i);
    sum += d;
    squares += d * d;
  }
  const double n = double(points.size()), mean = sum / n;
  return std::sqrt(squares / n - mean * mean) / mean;
}

/// The largest distance from a place of the square [0, size]^2 to the nearest point
inline double largest_gap(const Points& points, double size)
{
  double largest = 0.;
  for (double x = 0.; x <= size; x += .25)
    for (double y = 0.; y <= size; y += .25)
      largest = (std::max)(largest, nearest_distance(points, Point_3(x, y, 0.), points.size()));
  return largest;
}

inline double largest_coordinate(const Points& points, int axis)
{
  return (*std::max_element(points.begin(), points.end(), [=](const Point_3& a, const Point_3& b) {
    return a[axis] < b[axis];
  }))[axis];
}

} // namespace relaxation

BOOST_AUTO_TEST_SUITE(relaxation_along_the_surface)

BOOST_AUTO_TEST_CASE(a_patch_becomes_even_and_keeps_its_plane_and_its_border)
{
  using namespace relaxation;
  const int m = 40;
  const Points before = patch(m, .7), after = smoothed(before, 5);
  for (const Point_3& p : after)
    BOOST_REQUIRE(std::abs(p.z()) < 1e-9);
  BOOST_TEST(unevenness(after) < .6 * unevenness(before));
  BOOST_TEST(largest_gap(after, m - 1.) <= largest_gap(before, m - 1.));
  for (const int axis : {0, 1}) {
    BOOST_TEST(largest_coordinate(after, axis) <= largest_coordinate(before, axis) + .1);
    BOOST_TEST(largest_coordinate(after, axis) >= largest_coordinate(before, axis) - .1);
  }
}

BOOST_AUTO_TEST_CASE(a_hole_neither_closes_nor_grows_and_no_other_opens)
{
  using namespace relaxation;
  const Point_3 center(20., 20., 0.);
  Points before;
  for (const Point_3& p : patch(40, .5))
    if (CGAL::squared_distance(p, center) > 36.)
      before.push_back(p);
  const Points after = smoothed(before, 5);
  const auto hole = [&](const Points& points) {
    return nearest_distance(points, center, points.size());
  };
  BOOST_TEST(hole(after) < hole(before) + .1);
  BOOST_TEST(hole(after) > hole(before) - .6);
  const auto filled = [&](Points points) {
    points.insert(points.end(), 1, center);
    for (int r = 1; r < 6; ++r)
      for (int i = 0; i < 36; ++i)
        points.emplace_back(20. + r * std::cos(i * CGAL_PI / 18.),
                            20. + r * std::sin(i * CGAL_PI / 18.), 0.);
    return points;
  };
  BOOST_TEST(largest_gap(filled(after), 39.) <= largest_gap(filled(before), 39.) + .05);
}

BOOST_AUTO_TEST_CASE(a_lattice_hardly_moves)
{
  using namespace relaxation;
  const Points before = patch(30, 0.);
  BOOST_TEST(shapes::largest_difference(before, smoothed(before, 5)) < .15);
  Points inner_before, inner_after;
  const Points after = smoothed(before, 5);
  for (std::size_t i = 0; i < before.size(); ++i)
    if (before[i].x() > 6. && before[i].x() < 23. && before[i].y() > 6. && before[i].y() < 23.) {
      inner_before.push_back(before[i]);
      inner_after.push_back(after[i]);
    }
  BOOST_TEST(shapes::largest_difference(inner_before, inner_after) < .01);
}

BOOST_AUTO_TEST_CASE(constrained_points_stay)
{
  using namespace relaxation;
  const Points before = shapes::noisy_cube();
  std::vector<char> constrained;
  for (std::size_t i = 0; i < before.size(); ++i)
    constrained.push_back(i % 3 == 0);
  const Points after = smoothed(before, 3, constrained), flowed = smoothed(before, 0, constrained);
  for (std::size_t i = 0; i < before.size(); i += 3)
    BOOST_REQUIRE((after[i] == before[i]));
  BOOST_TEST(shapes::largest_difference(after, flowed) > .01);
}

BOOST_AUTO_TEST_CASE(edges_and_corners_stay_sharp)
{
  using namespace relaxation;
  for (const double noise : {0., .01, .03}) {
    const Points before = shapes::noisy_cube(24, noise);
    const Points flowed = smoothed(before, 0), relaxed = smoothed(before, 5);
    BOOST_TEST_MESSAGE("cube, noise "
                       << noise << ": " << shapes::rms(flowed, shapes::distance_to_cube) << " to "
                       << shapes::rms(relaxed, shapes::distance_to_cube) << ", uneven "
                       << unevenness(flowed) << " to " << unevenness(relaxed));
    BOOST_TEST(shapes::rms(relaxed, shapes::distance_to_cube) <
               1.03 * shapes::rms(flowed, shapes::distance_to_cube) + .0025); // .03 spacings
    BOOST_TEST(unevenness(relaxed) < .7 * unevenness(flowed));
    // there are still points near all edges: the faces do not draw away from them
    for (const double x : {-1., 1.})
      for (const double y : {-1., 1.})
        for (double z = -.9; z < .95; z += .1)
          BOOST_REQUIRE(nearest_distance(relaxed, Point_3(x, y, z), relaxed.size()) <
                        nearest_distance(flowed, Point_3(x, y, z), flowed.size()) + .05);
  }
}

BOOST_AUTO_TEST_CASE(opposite_sheets_do_not_repel_each_other)
{
  using namespace relaxation;
  Points wall = patch(30, 0.); // a lattice, and another one nearly behind it
  for (const Point_3& p : patch(30, 0.))
    wall.emplace_back(p.x() + .2, p.y() + .1, 2.5);
  const Points after = smoothed(wall, 5);
  for (std::size_t i = 0; i < wall.size(); ++i)
    if (wall[i].x() > 6. && wall[i].x() < 23. && wall[i].y() > 6. && wall[i].y() < 23.)
      BOOST_REQUIRE(CGAL::squared_distance(after[i], wall[i]) < .01);
}

BOOST_AUTO_TEST_CASE(points_in_scan_lines_stay_in_them)
{
  using namespace relaxation;
  Points before;
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  for (int line = 0; line < 12; ++line)
    for (int i = 0; i < 200; ++i) {
      const double x = i + .2 * normal(random), y = 12. * line + .2 * normal(random);
      before.emplace_back(x, y, .2 * normal(random));
    }
  const Points after = smoothed(before, 5);
  const auto off_line = [](const Point_3& p) { return std::remainder(p.y(), 12.); };
  BOOST_TEST(shapes::rms(after, off_line) < 1.5 * shapes::rms(before, off_line));
}

BOOST_AUTO_TEST_CASE(a_sphere_keeps_its_radius_and_becomes_even)
{
  using namespace relaxation;
  Points noisy = shapes::sphere(2000, 1.);
  shapes::add_noise(noisy, .02);
  const Points flowed = smoothed(noisy, 0), relaxed = smoothed(noisy, 5);
  BOOST_TEST(std::abs(shapes::mean_radius(relaxed) - shapes::mean_radius(flowed)) < 5e-4);
  const auto error = [](const Point_3& p) { return shapes::distance_to_origin(p) - 1.; };
  BOOST_TEST(shapes::rms(relaxed, error) < 1.02 * shapes::rms(flowed, error));
  BOOST_TEST(unevenness(relaxed) < .5 * unevenness(flowed));
}

BOOST_AUTO_TEST_SUITE_END()

#endif // CGAL_POINT_SET_FLOW_TEST_RELAXATION_H
