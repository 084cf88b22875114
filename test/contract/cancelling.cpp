// SPDX-License-Identifier: GPL-3.0-or-later
// The contract of balanced_flow_smooth_point_set(): progress, cancelling, degenerate and adverse input.
#define BOOST_TEST_MODULE safety
#include <boost/test/unit_test.hpp>

#include "smoothed.h"

#include <boost/property_map/property_map.hpp>

#include <map>
#include <numeric>
#include <tuple>

namespace np = CGAL::parameters;
using namespace CGAL::Point_set_flow;
using shapes::largest_difference;
using shapes::noisy_cube;
using shapes::Points;
typedef CGAL::Sequential_tag Sequential;

// ---- progress and cancelling

namespace {
template <typename Parameters>
void check_progress(std::size_t m, const Parameters& parameters)
{
  Points points = noisy_cube(int(m));
  std::vector<double> shares;
  CGAL::balanced_flow_smooth_point_set<CGAL::Parallel_if_available_tag>(
      points, parameters.callback([&](double share) {
        shares.push_back(share);
        return true;
      }));
  BOOST_TEST(shares.size() >= 20u);
  BOOST_TEST(shares.front() == 0.);
  BOOST_TEST(shares.back() == 1.);
  BOOST_TEST(std::is_sorted(shares.begin(), shares.end()));
  BOOST_TEST(shares[shares.size() - 2] > .9);
}
} // namespace

BOOST_AUTO_TEST_CASE(the_progress_rises_from_0_to_1)
{
  for (const std::size_t m : {3u, 40u}) {
    std::map<shapes::Point_3, shapes::Vector_3> normals;
    std::map<shapes::Point_3, double> strengths;
    for (const auto& p : noisy_cube(int(m))) {
      normals.emplace(p, shapes::Vector_3(0, 0, 1));
      strengths.emplace(p, 0.);
    }
    const auto normal_map = boost::make_assoc_property_map(normals);
    const auto strength_map = boost::make_assoc_property_map(strengths);
    check_progress(m, np::number_of_iterations(6));
    check_progress(m, np::block_size(1024));
    check_progress(m, np::curvature(Covariance_curvature()));
    check_progress(m, np::curvature(Covariance_curvature()).flow(Curvature_flow()));
    check_progress(m, np::curvature(Covariance_curvature()).block_size(2048));
    check_progress(m, np::feature_strength_map(strength_map).normal_map(normal_map));
    check_progress(m,
                   np::feature_strength_map(strength_map).block_size(1024).normal_map(normal_map));
  }
}

BOOST_AUTO_TEST_CASE(a_cancelled_run_changes_nothing)
{
  typedef std::pair<shapes::Point_3, shapes::Vector_3> Pair;
  std::vector<Pair> noisy;
  for (const auto& p : noisy_cube(20))
    noisy.emplace_back(p, shapes::Vector_3(0, 0, 2));
  const auto run = [&](auto tag, double stop_at) {
    std::vector<Pair> pairs = noisy;
    const double moved = CGAL::balanced_flow_smooth_point_set<decltype(tag)>(
        pairs, 20,
        np::point_map(CGAL::First_of_pair_property_map<Pair>())
            .normal_map(CGAL::Second_of_pair_property_map<Pair>())
            .callback([=](double share) { return share < stop_at; }));
    BOOST_TEST(std::isnan(moved));
    BOOST_TEST((pairs == noisy));
  };
  for (const double stop_at : {0., .3, .99, 1.}) {
    run(Sequential(), stop_at);
    run(CGAL::Parallel_if_available_tag(), stop_at);
  }
}

// ---- errors and small inputs

BOOST_AUTO_TEST_CASE(small_and_degenerate_inputs)
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

BOOST_AUTO_TEST_CASE(constrained_points_stay)
{
  const Points noisy = noisy_cube();
  std::vector<std::size_t> indices(noisy.size());
  std::iota(indices.begin(), indices.end(), std::size_t(0));
  Points points = noisy;
  std::vector<char> fixed(noisy.size());
  for (std::size_t i = 0; i < noisy.size(); i += 3)
    fixed[i] = 1;
  CGAL::balanced_flow_smooth_point_set<Sequential>(
      indices, 20,
      np::point_map(CGAL::make_property_map(points))
          .point_is_constrained_map(CGAL::make_property_map(fixed)));
  std::size_t moved = 0;
  for (std::size_t i = 0; i < noisy.size(); ++i) {
    if (fixed[i])
      BOOST_REQUIRE((points[i] == noisy[i]));
    else if (points[i] != noisy[i])
      ++moved;
  }
  BOOST_TEST(moved > noisy.size() / 2);
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

BOOST_AUTO_TEST_CASE(a_flow_that_diverges_is_an_error)
{
  const Points noisy = noisy_cube(6);
  Points points = noisy;
  BOOST_CHECK_THROW(CGAL::balanced_flow_smooth_point_set<Sequential>(
                        points, 20, np::step_length(1e40).curvature(Covariance_curvature())),
                    std::overflow_error);
  BOOST_TEST((points == noisy));

  Points plane = shapes::disc(100);
  CGAL::balanced_flow_smooth_point_set<Sequential>(plane, 20, np::sharpness_angle(1e-80));
  BOOST_TEST((plane == shapes::disc(100)));
}
