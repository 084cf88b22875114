// SPDX-License-Identifier: GPL-3.0-or-later
// The stages one by one, against known answers and against CGAL. All tests that look at internal
// headers are here.
#define BOOST_TEST_MODULE stages
#include <boost/test/unit_test.hpp>

#include "shapes.h"

#include <CGAL/Point_set_flow/Covariance_curvature.h>
#include <CGAL/Point_set_flow/Diffusivity.h>
#include <CGAL/Point_set_flow/estimate_point_set_scale.h>
#include <CGAL/Point_set_flow/internal/neighbors/Neighbor_graph.h>
#include <CGAL/Point_set_flow/internal/neighbors/nearest_points.h>
#include <CGAL/Point_set_flow/internal/noise/two_sheets.h>
#include <CGAL/Point_set_flow/internal/order/Point_buffer.h>
#include <CGAL/Point_set_flow/internal/flow/prefilter.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/estimate_point_set_noise.h>

#include <numeric>

using namespace CGAL::Point_set_flow;
namespace internal = CGAL::Point_set_flow::internal;

namespace {

typedef internal::Loops<CGAL::Sequential_tag> Loops;

void require_same_neighborhood(const internal::Neighbor_graph& a, const internal::Neighbor_graph& b,
                               std::size_t i)
{
  BOOST_REQUIRE(a.size(i) == b.size(i));
  BOOST_REQUIRE(a.radius(i) == b.radius(i));
  for (std::size_t j = 0; j < a.size(i); ++j)
    BOOST_REQUIRE(a.neighbors(i)[j] == b.neighbors(i)[j]);
}
} // namespace

BOOST_AUTO_TEST_CASE(the_diffusivity_falls_from_1_through_one_half_at_the_threshold)
{
  const Diffusivity g(400.); // 1 / sqrt(400) = 0.05
  BOOST_TEST(g(0.) == 1.);
  BOOST_TEST(g(.05) == .5, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(Diffusivity::half_at(.05)(.05) == .5, boost::test_tools::tolerance(1e-14));
  for (double x = 0.; x < .33; x += .01)
    BOOST_TEST(g(x) > g(x + .01));
  BOOST_TEST(g(1. / 3.) > 0.);
  BOOST_TEST(Diffusivity(0.)(.3) == 1.);
}

namespace {

// The stages work on arrays.
typedef internal::Array<Point_3> Points;

Points array(const shapes::Points& points) { return Points(points.begin(), points.end()); }

/// A surface, a lattice, where many distances are equal, and a point far away
Points points_of_all_kinds()
{
  Points points = array(shapes::cube(12));
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j)
      for (int l = 0; l < 5; ++l)
        points.emplace_back(3. + i, j, l);
  points.emplace_back(1e6, 0., 0.);
  return points;
}

/// All other points, nearest first, ties by index
std::vector<internal::Neighbor> by_distance(const Points& points, std::size_t i)
{
  std::vector<internal::Neighbor> sorted;
  for (std::size_t j = 0; j < points.size(); ++j)
    if (j != i)
      sorted.push_back({CGAL::squared_distance(points[i], points[j]), std::uint32_t(j)});
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

} // namespace

BOOST_AUTO_TEST_CASE(the_graph_has_the_nearest_neighbors)
{
  const Points points = points_of_all_kinds();
  Loops loops(nullptr, 1.);
  const internal::Neighbor_tree tree(points, loops);
  for (const double radius : {0., .4}) // without a limit, and with one
    for (const std::size_t k : {std::size_t(1), std::size_t(7), std::size_t(30), points.size()}) {
      internal::Neighbor_graph graph(tree, {k, radius, {}, nullptr}, loops);
      const auto check = [&](std::size_t i, std::size_t most) {
        auto expected = by_distance(points, i);
        expected.resize((std::min)(most, expected.size()));
        while (radius > 0. && !expected.empty() &&
               expected.back().squared_distance > radius * radius)
          expected.pop_back();
        BOOST_REQUIRE(graph.size(i) == expected.size());
        const double farthest = expected.empty() ? 0. : expected.back().squared_distance;
        BOOST_REQUIRE(graph.radius(i) == std::sqrt(farthest));
        for (std::size_t j = 0; j < expected.size(); ++j)
          BOOST_REQUIRE(graph.neighbors(i)[j] == expected[j].index);
      };
      for (std::size_t i = 0; i < points.size(); i += 3)
        check(i, k);
      internal::Array<std::uint32_t> sizes(points.size());
      for (std::size_t i = 0; i < sizes.size(); ++i)
        sizes[i] = std::uint32_t(1 + i % 20);
      graph.shrink(points, sizes, loops);
      for (std::size_t i = 0; i < points.size(); i += 7)
        check(i, (std::min)(k, std::size_t(sizes[i])));
    }
}

BOOST_AUTO_TEST_CASE(a_graph_of_few_points_has_as_many_neighbors_as_wanted)
{
  Loops loops(nullptr, 1.);
  for (const std::size_t n : {10u, 33u, 91u, 300u}) {
    const Points points = array(shapes::sphere(n, 1.));
    const internal::Neighbor_tree tree(points, loops);
    for (const std::size_t k : {n / 4, n / 2, 2 * n / 3, n - 2}) {
      const internal::Neighbor_graph graph(tree, {k}, loops);
      for (std::size_t i = 0; i < n; ++i) {
        BOOST_REQUIRE(graph.size(i) == k);
        BOOST_REQUIRE(graph.radius(i) == std::sqrt(by_distance(points, i)[k - 1].squared_distance));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(parts_of_the_points_have_numbers_of_neighbors_of_their_own)
{
  const Points points = points_of_all_kinds();
  Loops loops(nullptr, 1.);
  const internal::Neighbor_tree tree(points, loops);
  internal::Array<std::uint32_t> part_of;
  for (std::size_t i = 0; i < points.size(); ++i)
    part_of.push_back(std::uint32_t(i / 50 % 3));
  const std::vector<std::uint32_t> sizes = {5, 40, 1000000};
  const internal::Neighbor_graph graph(tree, {0, 0., sizes, &part_of}, loops);
  for (std::size_t part = 0; part < 3; ++part) {
    const internal::Neighbor_graph alike(tree, {sizes[part]}, loops);
    for (std::size_t i = 0; i < points.size(); ++i)
      if (part_of[i] == part) {
        require_same_neighborhood(graph, alike, i);
      }
  }
}

BOOST_AUTO_TEST_CASE(neighbors_are_the_nearest_ones)
{
  const Points points = points_of_all_kinds();
  typedef CGAL::Orthogonal_k_neighbor_search<CGAL::Search_traits_3<Core_kernel>> Search;
  Search::Tree cgal_tree(points.begin(), points.end());
  Loops loops(nullptr, 1.);
  const internal::Neighbor_tree tree(points, loops);
  for (const unsigned int k : {1u, 7u, 30u}) {
    internal::Neighbor_query query(tree, k);
    internal::Neighbor_query within(tree, k, .4), anywhere(tree, k);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto expected = by_distance(points, i);
      const auto found = query(i);
      BOOST_REQUIRE(found.size() == k);
      for (std::size_t j = 0; j < k; ++j)
        BOOST_REQUIRE(found[j].index == expected[j].index);

      Search search(cgal_tree, points[i], k + 1);
      double farthest = 0.;
      for (const auto& neighbor : search)
        farthest = (std::max)(farthest, neighbor.second);
      BOOST_REQUIRE(found.back().squared_distance == farthest);

      // the same place as a place, where the point itself is the nearest
      const auto& around = anywhere(points[i]);
      BOOST_REQUIRE(around.front().squared_distance == 0.);
      for (std::size_t j = 1; j < k; ++j)
        BOOST_REQUIRE(around[j].squared_distance == expected[j - 1].squared_distance);

      const auto near = within(i);
      const std::size_t in_ball =
          std::size_t(std::count_if(expected.begin(), expected.end(),
                                    [](const auto& n) { return n.squared_distance <= .4 * .4; }));
      BOOST_REQUIRE(near.size() == (std::min)(std::size_t(k), in_ball));
      for (std::size_t j = 0; j < near.size(); ++j)
        BOOST_REQUIRE(near[j].index == expected[j].index);
    }
  }
}

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
double path_length(const Points& points)
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

// Section 2.3, Fig. 3: variation measured on the prefiltered surface depends less on the noise
BOOST_AUTO_TEST_CASE(the_prefilter_brings_the_variation_nearer_to_that_of_the_clean_surface)
{
  Points clean = array(shapes::sphere(4000, 1.)), noisy = clean;
  shapes::add_noise(noisy, .01);
  Loops loops(nullptr, 1.);
  const internal::Neighbor_tree tree(clean, loops);
  const internal::Neighbor_graph graph(tree, {20}, loops);
  Points filtered;
  internal::prefilter(noisy, graph, .5, filtered, loops);

  const Covariance_curvature curvature;
  double of_clean = 0., of_noisy = 0., of_filtered = 0.;
  for (std::size_t i = 0; i < clean.size(); ++i) {
    of_clean += curvature.tangent_plane(graph.neighborhood(clean, i, .5)).variation;
    of_noisy += curvature.tangent_plane(graph.neighborhood(noisy, i, .5)).variation;
    of_filtered += curvature.tangent_plane(graph.neighborhood(filtered, i, .5)).variation;
  }
  BOOST_TEST(std::abs(of_filtered - of_clean) < .2 * std::abs(of_noisy - of_clean));
}

BOOST_AUTO_TEST_CASE(noise_and_spacing_are_estimated)
{
  // unit area per point would be a spacing of 1: here the area is 4 pi over 20,000 points
  const double spacing = std::sqrt(4. * CGAL_PI / 20000.);
  for (const double in_spacings : {.03, .1, .5, 1., 2.}) {
    Points points = array(shapes::sphere(20000, 1.));
    shapes::add_noise(points, in_spacings * spacing);
    const Point_set_scale scale = estimate_point_set_scale<CGAL::Sequential_tag>(points);
    BOOST_TEST_CONTEXT("noise of " << in_spacings << " spacings")
    {
      BOOST_TEST(scale.noise == in_spacings * spacing, boost::test_tools::tolerance(.15));
      BOOST_TEST(scale.spacing == spacing, boost::test_tools::tolerance(.15));
      BOOST_TEST(scale.k >= 24u);
      BOOST_TEST(scale.k <= 128u);
      BOOST_TEST(CGAL::estimate_point_set_noise<CGAL::Sequential_tag>(points) == scale.noise);
    }
  }
  BOOST_TEST(estimate_point_set_scale<CGAL::Sequential_tag>(shapes::sphere(20000, 1.)).noise <
             1e-3 * spacing);
  BOOST_TEST(estimate_point_set_scale<CGAL::Sequential_tag>(shapes::sphere(10, 1.)).noise == 0.);
  BOOST_TEST(estimate_point_set_scale<CGAL::Sequential_tag>(Points()).spacing == 0.);
}

// Lines, pixel columns and copies: small neighborhoods there are no pieces of a surface, and a
// quadric fits them exactly.
BOOST_AUTO_TEST_CASE(neighborhoods_are_two_dimensional_before_anything_is_fitted)
{
  std::mt19937 random(5);
  std::normal_distribution<double> gauss(0., 1.);
  const auto height = [](double x, double y) { return .5 * std::sin(.2 * x) * std::cos(.3 * y); };
  const auto estimate = [&](const char* what, double noise, const Points& points) {
    const double found = estimate_point_set_scale<CGAL::Sequential_tag>(points).noise;
    BOOST_TEST(found == noise, boost::test_tools::tolerance(.3));
    BOOST_TEST_MESSAGE(what << ": " << found / noise);
  };
  Points profiles, frames, copies;
  for (int i = 0; i < 1000; ++i) // 12 times coarser across than along
    for (int j = 0; j < 10; ++j) {
      const double x = .25 * (i + .1 * gauss(random)), y = 3. * j;
      profiles.emplace_back(x, y, height(x, y) + .05 * gauss(random));
    }
  estimate("profiles", .05, profiles);
  for (int i = 0; i < 30; ++i) // 12 frames of one camera
    for (int j = 0; j < 30; ++j)
      for (int frame = 0; frame < 12; ++frame)
        frames.emplace_back(i, j, height(i, j) + .3 * gauss(random));
  estimate("frames", .3, frames);
  for (int i = 0; i < 5000; ++i) { // merged three times
    const double x = i % 71 + .3 * gauss(random), y = i / 71 + .3 * gauss(random);
    const Point_3 p(x, y, height(x, y) + .25 * gauss(random));
    for (int copy = 0; copy < 3; ++copy)
      copies.emplace_back(p.x() + 1e-6 * copy, p.y(), p.z());
  }
  estimate("copies", .25, copies);
}

BOOST_AUTO_TEST_CASE(thin_parts_are_distinguished_from_noise)
{
  const double spacing = std::sqrt(CGAL_PI / 4000.), sigma = .5 * spacing;
  for (const bool thin : {false, true}) {
    Points points = array(shapes::disc(4000)); // or two discs, four deviations apart
    for (std::size_t i = 0; thin && i < points.size(); i += 2)
      points[i] = Point_3(points[i].x(), points[i].y(), 4. * sigma);
    shapes::add_noise(points, sigma);
    Loops loops(nullptr, 1.);
    const internal::Neighbor_tree tree(points, loops);
    internal::Neighbor_graph graph(tree, {60}, loops);
    const double layer = (thin ? std::sqrt(5.) : 1.) * sigma;
    const std::vector<internal::Local_parameters> parts = {
        {layer, spacing, 60, 12, .6, {}, Diffusivity(0.)}};
    internal::Surface_state state = {{}, {}, {}, parts, 0., {}};
    state.planes.assign(points.size(), Vector_3(0, 0, 1));
    state.noise.assign(points.size(), layer);
    state.part_of.assign(points.size(), 0);
    const auto fit = [&](bool is_given) {
      const internal::Surface surface{points, graph, state};
      internal::Array<signed char> sides;
      auto moments = internal::find_moments(surface, sides, loops);
      internal::pool(graph, moments, loops);
      return internal::fit_sheets(surface, moments, std::move(sides),
                                  Tangent_plane_curvature::defaults(), state.noise, is_given,
                                  loops);
    };
    const internal::Array<std::uint32_t> sizes = fit(false).sizes;
    const double noise =
        std::accumulate(state.noise.begin(), state.noise.end(), 0.) / double(points.size());
    const double size = std::accumulate(sizes.begin(), sizes.end(), 0.) / double(points.size());
    BOOST_TEST_CONTEXT(thin)
    {
      BOOST_TEST(noise == sigma, boost::test_tools::tolerance(.25));
      if (thin)
        BOOST_TEST(size < 25.);
      else
        BOOST_TEST(size > 30.);
    }
    // what the caller gives is not doubted
    const internal::Array<double> given = state.noise;
    fit(true);
    BOOST_TEST((state.noise == given));
  }
}

BOOST_AUTO_TEST_CASE(a_graph_holds_neighbors_that_are_far_in_the_order_of_the_points)
{
  // two lines beside each other, one after the other in memory: the nearest point is on the other line
  Points points;
  const std::size_t n = 40000;
  for (const double y : {0., .5})
    for (std::size_t i = 0; i < n; ++i)
      points.emplace_back(double(i), y, 0.);
  Loops loops(nullptr, 1.);
  const internal::Neighbor_tree tree(points, loops);
  internal::Neighbor_graph graph(tree, {3}, loops);
  for (const std::size_t size : {std::size_t(3), std::size_t(1)}) {
    for (std::size_t i = 1; i + 1 < n; i += 100) {
      BOOST_REQUIRE(graph.size(i) == size);
      BOOST_REQUIRE(graph.neighbors(i)[0] == n + i);
      BOOST_REQUIRE(graph.neighbors(n + i)[0] == i);
      if (size == 3)
        BOOST_REQUIRE(graph.neighbors(i)[1] == i - 1);
    }
    graph.shrink(points, internal::Array<std::uint32_t>(points.size(), 1), loops);
  }
}

BOOST_AUTO_TEST_CASE(a_graph_adapts_to_other_numbers_of_neighbors)
{
  const Points points = points_of_all_kinds();
  Loops loops(nullptr, 1.);
  const internal::Neighbor_tree tree(points, loops);
  internal::Array<std::uint32_t> part_of;
  for (std::size_t i = 0; i < points.size(); ++i)
    part_of.push_back(std::uint32_t(i / 5 % 3));
  const internal::Search_options search = {0, 0., {7, 20, 50}, &part_of};
  const internal::Neighbor_graph expected(tree, search, loops);
  internal::Neighbor_graph graph(tree, {20}, loops);
  graph.adapt(tree, search, loops);
  for (std::size_t i = 0; i < points.size(); ++i) {
    require_same_neighborhood(graph, expected, i);
  }
}

BOOST_AUTO_TEST_CASE(each_place_has_its_nearest_point)
{
  const Points points = points_of_all_kinds();
  Loops loops(nullptr, 1.);
  for (const std::size_t share : {std::size_t(1), std::size_t(20), points.size()}) {
    Points some;
    for (std::size_t i = 0; i < points.size(); i += share)
      some.push_back(points[i]);
    const internal::Neighbor_tree tree(some, loops);
    const auto nearest = internal::nearest_points(tree, points, loops);
    for (std::size_t i = 0; i < points.size(); ++i) {
      std::size_t expected = 0;
      for (std::size_t j = 1; j < some.size(); ++j)
        if (CGAL::squared_distance(points[i], some[j]) <
            CGAL::squared_distance(points[i], some[expected]))
          expected = j;
      BOOST_REQUIRE(nearest[i] == expected);
    }
  }
}
