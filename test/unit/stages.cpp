// SPDX-License-Identifier: GPL-3.0-or-later
// The stages one by one, against known answers and against CGAL. All tests that look at internal
// headers are here. One program, since all of its tests would compile the same.
#define BOOST_TEST_MODULE stages
#include <boost/test/unit_test.hpp>

#include "cuts.h"
#include "neighbors.h"
#include "order.h"

#include <CGAL/Point_set_flow/Covariance_curvature.h>
#include <CGAL/Point_set_flow/Diffusivity.h>
#include <CGAL/Point_set_flow/estimate_point_set_scale.h>
#include <CGAL/Point_set_flow/internal/flow/prefilter.h>
#include <CGAL/Point_set_flow/internal/noise/two_sheets.h>
#include <CGAL/estimate_point_set_noise.h>

using namespace stages;

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
    internal::Surface_state state = {{}, {}, {}, {}, parts, 0., {}};
    state.normals.assign(internal::Array<Vector_3>(points.size(), Vector_3(0, 0, 1)));
    state.noise.assign(points.size(), float(layer / spacing));
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
    const double noise = std::accumulate(state.noise.begin(), state.noise.end(), 0.) /
                         double(points.size()) * spacing;
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
    const internal::Array<float> given = state.noise;
    fit(true);
    BOOST_TEST((state.noise == given));
  }
}

BOOST_AUTO_TEST_CASE(compact_lengths_are_rounded_up_by_little_at_any_scale)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> digits(1., 2.);
  for (int exponent = -1000; exponent <= 1000; exponent += 10) {
    const double length = std::ldexp(digits(random), exponent);
    const double compact = Compact_length(length).value();
    BOOST_TEST(compact >= length);
    BOOST_TEST(compact <= length * (1. + Compact_length::rounding));
    BOOST_TEST(Compact_length(compact).value() == compact);
  }
  BOOST_TEST(Compact_length(0.).value() == 0.);
  BOOST_TEST(Compact_length().value() == 0.);
}

BOOST_AUTO_TEST_CASE(moments_in_single_precision_keep_their_kurtosis_at_any_scale)
{
  for (const double deviation : {1e-15, 1e-3, 1., 1e6, 1e15})
    for (const double kurtosis : {1., 1.8, 3., 30.}) {
      const double second = deviation * deviation;
      const internal::Compact_moments compact(
          internal::Distance_moments(second, kurtosis * second * second));
      BOOST_TEST(compact.deviation() == deviation, boost::test_tools::tolerance(1e-6));
      BOOST_TEST(std::abs(compact.moments().excess() - (kurtosis - 3.)) < 1e-6 * kurtosis);
    }
  const internal::Compact_moments none(internal::Distance_moments(0., 0.));
  BOOST_TEST(none.moments().excess() == 0.);
}
