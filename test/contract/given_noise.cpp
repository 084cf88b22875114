// SPDX-License-Identifier: GPL-3.0-or-later
// The named parameter noise: what the caller knows replaces the estimate.
#define BOOST_TEST_MODULE given_noise
#include <boost/test/unit_test.hpp>

#include "shapes.h"

#include <CGAL/Point_set_flow/Covariance_curvature.h>
#include <CGAL/Point_set_flow/analyze_point_set.h>
#include <CGAL/balanced_flow_smooth_point_set.h>

#include <functional>
#include <numeric>
#include <string>

namespace np = CGAL::parameters;
using namespace CGAL::Point_set_flow;
using shapes::largest_difference;
using shapes::noisy_cube;
using shapes::Points;
typedef CGAL::Sequential_tag Sequential;

namespace {

template <typename Tag = Sequential, typename NamedParameters>
Points smoothed(Points points, const NamedParameters& parameters)
{
  CGAL::balanced_flow_smooth_point_set<Tag>(points, parameters);
  return points;
}

/// With a number for each point, in a vector
template <typename Tag = Sequential, typename Number>
Points smoothed_with_map(Points points, std::vector<Number> noise,
                         unsigned int block_size = 1000000)
{
  std::vector<std::size_t> indices(points.size());
  std::iota(indices.begin(), indices.end(), std::size_t(0));
  CGAL::balanced_flow_smooth_point_set<Tag>(indices,
                                            np::noise(CGAL::make_property_map(noise))
                                                .block_size(block_size)
                                                .point_map(CGAL::make_property_map(points)));
  return points;
}

/// For each point another noise, which depends on where it is; none on one side
std::vector<double> uneven_noise(const Points& points)
{
  std::vector<double> noise;
  for (const auto& p : points)
    noise.push_back(p.x() < 0. ? 0. : .02 + .01 * p.y());
  return noise;
}

} // namespace

BOOST_AUTO_TEST_CASE(the_given_noise_is_used_and_reported)
{
  const Points noisy = noisy_cube();
  Smoothing_report report;
  const Points result = smoothed(noisy, np::noise(.03).smoothing_report(std::ref(report)));
  BOOST_TEST(report.noise == .03);
  BOOST_TEST((result != smoothed(noisy, np::update_period(4))));
  BOOST_TEST((result != smoothed(noisy, np::noise(.02))));
  const auto most = [&](double noise) {
    return analyze_point_set<Sequential>(noisy, np::noise(noise)).most_neighbors;
  };
  BOOST_TEST(most(.01) < most(.1));
  BOOST_TEST(most(.1) < most(.5));
  BOOST_TEST(most(1e300) == 128u);

  // a map is reported by its median
  std::vector<double> noise(noisy.size(), .03);
  std::fill_n(noise.begin(), noise.size() / 3, .2);
  std::vector<std::size_t> indices(noisy.size());
  std::iota(indices.begin(), indices.end(), std::size_t(0));
  const Smoothing_report of_map = analyze_point_set<Sequential>(
      indices, np::noise(CGAL::make_property_map(noise)).point_map(CGAL::make_property_map(noisy)));
  BOOST_TEST(of_map.noise == .03);
  BOOST_TEST(of_map.most_neighbors <= most(.2));
  BOOST_TEST(of_map.most_neighbors > most(.1));
  BOOST_TEST(of_map.fewest_neighbors <= most(.03));
}

BOOST_AUTO_TEST_CASE(noise_below_what_can_be_estimated_is_removed_if_it_is_given)
{
  const std::size_t n = 4000;
  const double radius = 1., spacing = std::sqrt(4. * CGAL_PI / double(n)), sigma = .06 * spacing;
  Points noisy = shapes::sphere(n, radius);
  shapes::add_noise(noisy, sigma);
  const auto distance = [&](const shapes::Point_3& p) {
    return shapes::distance_to_origin(p) - radius;
  };
  const double before = shapes::rms(noisy, distance);
  BOOST_TEST(shapes::rms(smoothed(noisy, np::noise(sigma)), distance) < .6 * before);
}

BOOST_AUTO_TEST_CASE(without_noise_nothing_moves)
{
  const Points noisy = noisy_cube();
  Smoothing_report report;
  BOOST_TEST((smoothed(noisy, np::noise(0).smoothing_report(std::ref(report))) == noisy));
  BOOST_TEST(report.noise == 0.);
  BOOST_TEST(report.number_of_points_without_noise == noisy.size());
  BOOST_TEST((smoothed(noisy, np::noise(1e-300)) == noisy));

  // on one side only
  const std::vector<double> noise = uneven_noise(noisy);
  const Points result = smoothed_with_map(noisy, noise);
  std::size_t moved = 0;
  for (std::size_t i = 0; i < noisy.size(); ++i)
    if (noise[i] == 0.)
      BOOST_REQUIRE((result[i] == noisy[i]));
    else
      moved += result[i] != noisy[i];
  BOOST_TEST(moved > noisy.size() / 3);
}

BOOST_AUTO_TEST_CASE(a_number_and_a_map_of_that_number_give_the_same_points)
{
  Points noisy = noisy_cube();
  for (std::size_t i = 0; i < 99; ++i) // duplicates
    noisy.push_back(noisy[i % 33]);
  const Points expected = smoothed(noisy, np::noise(.03f));
  BOOST_TEST((smoothed_with_map(noisy, std::vector<float>(noisy.size(), .03f)) == expected));
  BOOST_TEST(
      (smoothed_with_map(noisy, std::vector<double>(noisy.size(), double(.03f))) == expected));
  BOOST_TEST((smoothed(noisy, np::noise(1)) ==
              smoothed_with_map(noisy, std::vector<int>(noisy.size(), 1))));
  BOOST_TEST((smoothed(noisy, np::noise(.03f).point_map(
                                  CGAL::Identity_property_map<shapes::Point_3>())) == expected));
}

BOOST_AUTO_TEST_CASE(the_estimator_of_the_paper_takes_k_and_its_threshold_from_the_given_noise_only)
{
  const Points noisy = noisy_cube();
  const auto size = [&](double noise) {
    return analyze_point_set<Sequential>(noisy, np::noise(noise).curvature(Covariance_curvature()))
        .most_neighbors;
  };
  BOOST_TEST(size(.01) < size(1.));
  // with k and K given, nothing is left to be chosen
  const auto run = [&](double sigma) {
    Points points = noisy;
    CGAL::balanced_flow_smooth_point_set<Sequential>(
        points, 20, np::noise(sigma).curvature(Covariance_curvature()).feature_threshold(100.));
    return points;
  };
  BOOST_TEST((run(.05) == run(.5)));
  BOOST_TEST((run(.05) != noisy));
}

BOOST_AUTO_TEST_CASE(results_do_not_depend_on_order_threads_and_blocks)
{
  Points noisy = noisy_cube(30);
  std::vector<double> noise = uneven_noise(noisy);
  for (std::size_t i = 0; i < 60; ++i) { // duplicates with other numbers
    noisy.push_back(noisy[i % 20]);
    noise.push_back(.001 * double(i));
  }
  const Points expected = smoothed_with_map(noisy, noise);
  for (const unsigned int block_size : {1000u, 3000u})
    BOOST_TEST((smoothed_with_map(noisy, noise, block_size) == expected));
  BOOST_TEST((smoothed_with_map<CGAL::Parallel_if_available_tag>(noisy, noise) == expected));
  BOOST_TEST((smoothed(noisy, np::noise(.05).block_size(1000)) == smoothed(noisy, np::noise(.05))));

  std::vector<std::size_t> order(noisy.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::shuffle(order.begin(), order.end(), std::mt19937(5));
  Points shuffled;
  std::vector<double> of_shuffled;
  for (const std::size_t i : order) {
    shuffled.push_back(noisy[i]);
    of_shuffled.push_back(noise[i]);
  }
  const Points result = smoothed_with_map(shuffled, of_shuffled);
  for (std::size_t i = 0; i < order.size(); ++i)
    BOOST_REQUIRE((result[i] == expected[order[i]]));
}

BOOST_AUTO_TEST_CASE(the_noise_is_scaled_with_the_points)
{
  const Points noisy = noisy_cube(), expected = smoothed(noisy, np::noise(.03));
  for (const double scale : {1024., 1e-6, 1e-150, 1e150}) {
    Points points, reference;
    for (std::size_t i = 0; i < noisy.size(); ++i) {
      points.push_back(CGAL::ORIGIN + scale * (noisy[i] - CGAL::ORIGIN));
      reference.push_back(CGAL::ORIGIN + scale * (expected[i] - CGAL::ORIGIN));
    }
    const Points result = smoothed(points, np::noise(.03 * scale));
    for (std::size_t i = 0; i < noisy.size(); ++i)
      for (int d = 0; d < 3; ++d)
        BOOST_REQUIRE(std::abs(result[i][d] - reference[i][d]) < 1e-7 * scale);
  }
}

BOOST_AUTO_TEST_CASE(any_noise_gives_finite_points)
{
  const Points noisy = noisy_cube(8);
  for (const double noise : {5e-324, 1e-200, 1e-3, 1., 1e10, 1e200, 1.7e308})
    for (const double scale : {1e-200, 1., 1e200}) {
      Points points;
      for (const auto& p : noisy)
        points.push_back(CGAL::ORIGIN + scale * (p - CGAL::ORIGIN));
      for (const auto& p : smoothed(points, np::noise(noise)))
        for (int d = 0; d < 3; ++d)
          BOOST_REQUIRE(std::isfinite(p[d]));
    }
}
