// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_TEST_ORDER_H
#define CGAL_POINT_SET_FLOW_TEST_ORDER_H

#include "stage_clouds.h"

#include <CGAL/Point_set_flow/internal/order/Point_buffer.h>

#include <numeric>

// The order of the points, and what is merged on the way
namespace stages {

BOOST_AUTO_TEST_CASE(the_buffer_merges_duplicates_and_forgets_the_order)
{
  Points points = array(shapes::sphere(500, 1.));
  points.insert(points.end(), points.begin(), points.begin() + 100);
  Loops loops(nullptr, 1.);
  const internal::Point_buffer buffer(points, {}, {}, {}, loops);
  BOOST_TEST(buffer.size() == 500u);
  for (std::size_t i = 0; i < points.size(); ++i)
    BOOST_TEST((buffer.reference[buffer.site_of[i]] == points[i]));

  Points shuffled = points;
  std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937(3));
  const internal::Point_buffer other(shuffled, {}, {}, {}, loops);
  BOOST_TEST((other.reference == buffer.reference));

  // same start but different references: two different points
  const internal::Point_buffer two({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}},
                                   {{5, 5, 5}, {5, 5, 5}, {5, 5, 5}}, {}, {}, loops);
  BOOST_TEST(two.size() == 2u);

  // a duplicate of a constrained point does not move either
  const internal::Point_buffer fixed({{0, 0, 0}, {1, 0, 0}, {0, 0, 0}}, {}, {0, 0, 1}, {}, loops);
  BOOST_TEST(fixed.constrained[fixed.site_of[0]] == 1);
  BOOST_TEST(fixed.constrained[fixed.site_of[1]] == 0);

  // the noise of duplicates is the mean of theirs, exactly where all are the same
  internal::Given_noise given;
  given.of_each = {.1, .5, .1, .4, .1};
  const internal::Point_buffer noisy({{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 0, 0}}, {},
                                     {}, given, loops);
  BOOST_TEST(noisy.noise.of_each.size() == 2u);
  BOOST_TEST(noisy.noise.of_each[noisy.site_of[0]] == .1);
  BOOST_TEST(noisy.noise.of_each[noisy.site_of[1]] == .45, boost::test_tools::tolerance(1e-15));
}

// Of the path through the points in their order
inline double path_length(const Points& points)
{
  double length = 0.;
  for (std::size_t i = 1; i < points.size(); ++i)
    length += std::sqrt(CGAL::squared_distance(points[i - 1], points[i]));
  return length;
}

// Points far away, or clusters, must not cost the others their order: searching would be slow.
BOOST_AUTO_TEST_CASE(the_order_follows_space_at_any_scale)
{
  const Points sphere = array(shapes::sphere(5000, 1.));
  const double spacing = std::sqrt(4. * CGAL_PI / double(sphere.size()));
  Loops loops(nullptr, 1.);
  for (const double size : {1., 1e-6, 1e-12, 1e-300}) {
    Points points;
    for (const Point_3& p : sphere)
      points.emplace_back(size * p.x(), size * p.y(), size * p.z());
    points.emplace_back(1., 2., 3.);
    points.emplace_back(1e9, 0., 0.);
    std::shuffle(points.begin(), points.end(), std::mt19937(3));
    const internal::Spatial_order<CGAL::Sequential_tag> order(points, {}, loops);
    std::vector<std::uint32_t> all;
    Points near;
    for (std::size_t i = 0; i < order.size(); ++i) {
      all.push_back(order[i]);
      const Point_3& p = points[order[i]];
      if (std::abs(p.x()) <= size)
        near.emplace_back(p.x() / size, p.y() / size, p.z() / size);
    }
    std::sort(all.begin(), all.end());
    for (std::size_t i = 0; i < all.size(); ++i)
      BOOST_REQUIRE(all[i] == i);
    BOOST_TEST(near.size() >= sphere.size());
    BOOST_TEST(path_length(near) < 4. * spacing * double(near.size()));
  }
}

// So that a block of a point set comes out as in the whole
BOOST_AUTO_TEST_CASE(some_of_the_points_have_the_order_that_they_have_among_all)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1., 1.);
  Points points;
  for (const double size : {1., 1e-3, 1e-200, 5e-324, 1e12})
    for (int i = 0; i < 400; ++i)
      points.emplace_back(size * uniform(random), size * uniform(random), size * uniform(random));
  for (int i = 0; i < 100; ++i)
    points.emplace_back(uniform(random), double(i % 2), -0.);
  Loops loops(nullptr, 1.);
  const internal::Spatial_order<CGAL::Sequential_tag> order(points, {}, loops);
  for (const std::size_t share : {2u, 7u, 50u}) {
    Points some, expected, found;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (i % share == 0)
        some.push_back(points[i]);
    for (std::size_t i = 0; i < order.size(); ++i)
      if (order[i] % share == 0)
        expected.push_back(points[order[i]]);
    const internal::Spatial_order<CGAL::Sequential_tag> of_some(some, {}, loops);
    for (std::size_t i = 0; i < of_some.size(); ++i)
      found.push_back(some[of_some[i]]);
    BOOST_TEST((found == expected));
  }
}

} // namespace stages

#endif // CGAL_POINT_SET_FLOW_TEST_ORDER_H
