// SPDX-License-Identifier: GPL-3.0-or-later
// What analyze_point_set() and the named parameter smoothing_report tell of a run.
#define BOOST_TEST_MODULE report
#include <boost/test/unit_test.hpp>

#include "shapes.h"

#include <CGAL/Point_set_flow/Covariance_curvature.h>
#include <CGAL/Point_set_flow/analyze_point_set.h>
#include <CGAL/balanced_flow_smooth_point_set.h>
#include <CGAL/estimate_point_set_noise.h>

#include <cmath>
#include <functional>
#include <vector>

namespace np = CGAL::parameters;
using namespace CGAL::Point_set_flow;
using shapes::noisy_cube;
using shapes::Points;
typedef CGAL::Sequential_tag Sequential;

namespace {

Points with_duplicates(Points points)
{
  points.insert(points.end(), points.begin(), points.begin() + 10);
  return points;
}

void check_same_findings(const Smoothing_report& a, const Smoothing_report& b)
{
  BOOST_TEST(a.number_of_points == b.number_of_points);
  BOOST_TEST(a.number_of_distinct_points == b.number_of_distinct_points);
  BOOST_TEST(a.noise == b.noise);
  BOOST_TEST(a.spacing == b.spacing);
  BOOST_TEST(a.fewest_neighbors == b.fewest_neighbors);
  BOOST_TEST(a.most_neighbors == b.most_neighbors);
  BOOST_TEST(a.number_of_iterations == b.number_of_iterations);
  BOOST_TEST(a.number_of_relaxation_steps == b.number_of_relaxation_steps);
  BOOST_TEST(a.filter_width == b.filter_width);
  BOOST_TEST(a.feature_threshold == b.feature_threshold);
}

std::vector<std::size_t> counts(const Smoothing_report& r)
{
  return {r.number_of_moved_points, r.number_of_constrained_points, r.number_of_isolated_points,
          r.number_of_points_without_noise, r.number_of_points_at_rest};
}

/// The report of a run, whose counts are checked
template <typename NamedParameters>
Smoothing_report smooth(Points points, const NamedParameters& parameters)
{
  const Points before = points;
  Smoothing_report report;
  CGAL::balanced_flow_smooth_point_set<Sequential>(points,
                                                   parameters.smoothing_report(std::ref(report)));
  std::size_t moved = 0, all = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    moved += points[i] != before[i];
  for (const std::size_t count : counts(report))
    all += count;
  BOOST_TEST(report.number_of_moved_points == moved);
  BOOST_TEST(all == points.size());
  BOOST_TEST(report.number_of_points == points.size());
  return report;
}

} // namespace

BOOST_AUTO_TEST_CASE(the_analysis_finds_what_smoothing_finds_and_moves_nothing)
{
  const Points noisy = with_duplicates(noisy_cube(12));
  const auto check = [&](const auto& own) {
    Smoothing_report smoothed;
    Points points = noisy;
    const double moved = CGAL::balanced_flow_smooth_point_set<Sequential>(
        points, own.smoothing_report(std::ref(smoothed)));
    const Smoothing_report analyzed =
        analyze_point_set<CGAL::Parallel_if_available_tag>(noisy, own);
    check_same_findings(smoothed, analyzed);
    BOOST_TEST(analyzed.mean_movement == 0.);
    BOOST_TEST(counts(analyzed) == std::vector<std::size_t>(5, 0),
               boost::test_tools::per_element());
    BOOST_TEST(smoothed.last_movement == moved);
    double mean = 0.;
    for (std::size_t i = 0; i < noisy.size(); ++i)
      mean += std::sqrt(CGAL::squared_distance(points[i], noisy[i])) / double(noisy.size());
    BOOST_TEST(smoothed.mean_movement == mean, boost::test_tools::tolerance(1e-9));
  };
  check(np::update_period(4));
  check(np::curvature(Covariance_curvature()));
  check(np::curvature(Covariance_curvature()).flow(Anisotropic_flow()));
  check(np::block_size(1024).filter_width(.5));

  const Smoothing_report report = analyze_point_set<Sequential>(noisy, 30);
  BOOST_TEST(report.number_of_points == noisy.size());
  BOOST_TEST(report.number_of_distinct_points == noisy.size() - 10);
  BOOST_TEST(report.fewest_neighbors == 30u);
  BOOST_TEST(report.most_neighbors == 30u);
  BOOST_TEST(report.number_of_iterations == 5u);
  BOOST_TEST(report.noise == CGAL::estimate_point_set_noise<Sequential>(noisy));
  BOOST_TEST(analyze_point_set<Sequential>(noisy, np::feature_threshold(7.)).feature_threshold ==
             7.);
  BOOST_TEST(analyze_point_set<Sequential>(Points()).number_of_points == 0u);
}

BOOST_AUTO_TEST_CASE(lengths_are_in_the_unit_of_the_data)
{
  const Points noisy = noisy_cube(12);
  Points large;
  for (const auto& p : noisy)
    large.emplace_back(1024. * p.x(), 1024. * p.y(), 1024. * p.z());
  const Smoothing_report report = analyze_point_set<Sequential>(noisy),
                         of_large = analyze_point_set<Sequential>(large);
  BOOST_TEST(of_large.noise == 1024. * report.noise, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(of_large.spacing == 1024. * report.spacing, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(of_large.most_neighbors == report.most_neighbors);
}

BOOST_AUTO_TEST_CASE(movements_are_finite_lengths_at_any_scale)
{
  const auto movement = [](double scale) {
    Points points;
    for (const auto& p : noisy_cube(6))
      points.emplace_back(scale * p.x(), scale * p.y(), scale * p.z());
    Smoothing_report report;
    CGAL::balanced_flow_smooth_point_set<Sequential>(points,
                                                     np::smoothing_report(std::ref(report)));
    return report.mean_movement / scale;
  };
  for (const double scale : {1e200, 1e-200})
    BOOST_TEST(movement(scale) == movement(1.), boost::test_tools::tolerance(1e-6));
}

BOOST_AUTO_TEST_CASE(no_more_neighbors_are_reported_than_there_are)
{
  for (const std::size_t n : {std::size_t(1), std::size_t(10)}) {
    const Points all = noisy_cube(6), points(all.begin(), all.begin() + std::ptrdiff_t(n));
    BOOST_TEST(analyze_point_set<Sequential>(points).most_neighbors == n - 1);
    BOOST_TEST(analyze_point_set<Sequential>(points, 30).fewest_neighbors == n - 1);
  }
}

BOOST_AUTO_TEST_CASE(the_report_says_why_points_did_not_move)
{
  // a plane without noise
  const std::size_t n = 1000;
  const Points plane = shapes::disc(n);
  Smoothing_report report = smooth(plane, np::update_period(4));
  BOOST_TEST(report.number_of_moved_points == 0u);
  BOOST_TEST(report.number_of_points_without_noise + report.number_of_points_at_rest == n);
  report = smooth(plane, np::noise(0.));
  BOOST_TEST(report.number_of_points_without_noise == n);
  report = smooth(plane, np::noise(0.).step_length(0.)); // no step was made
  BOOST_TEST(report.number_of_points_at_rest == n);
  report = smooth(plane, np::noise(.1)); // a plane nevertheless
  BOOST_TEST(report.number_of_points_at_rest == n);
  report = smooth(plane, np::curvature(Covariance_curvature()));
  BOOST_TEST(report.number_of_points_at_rest == n);

  const Points noisy = with_duplicates(noisy_cube(12));
  report = smooth(noisy, np::step_length(0.));
  BOOST_TEST(report.number_of_points_at_rest == noisy.size());
  report = smooth(noisy, np::noise(.02));
  BOOST_TEST(report.number_of_moved_points > .9 * double(noisy.size()));

  // too few neighbors
  report = smooth({{0, 0, 0}, {1, 0, 0}}, np::update_period(4));
  BOOST_TEST(report.number_of_isolated_points == 2u);
  report = smooth({{0, 0, 0}, {0, 0, 0}}, np::update_period(4));
  BOOST_TEST(report.number_of_isolated_points == 2u);
  Points with_far = noisy;
  with_far.insert(with_far.end(), 3, shapes::Point_3(50., 50., 50.));
  with_far.emplace_back(90., 50., 50.);
  Points points = with_far;
  CGAL::balanced_flow_smooth_point_set<Sequential>(
      points, np::smoothing_report(std::ref(report)).neighbor_radius(1.));
  BOOST_TEST(report.number_of_isolated_points == 4u);
}

BOOST_AUTO_TEST_CASE(constrained_points_are_counted_with_their_duplicates)
{
  typedef std::pair<shapes::Point_3, bool> Pair;
  const Points noisy = with_duplicates(noisy_cube(12)); // of the first ten points
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < noisy.size(); ++i)
    pairs.emplace_back(noisy[i], i < 100);
  Smoothing_report report;
  CGAL::balanced_flow_smooth_point_set<Sequential>(
      pairs, np::smoothing_report(std::ref(report))
                 .point_map(CGAL::First_of_pair_property_map<Pair>())
                 .point_is_constrained_map(CGAL::Second_of_pair_property_map<Pair>()));
  BOOST_TEST(report.number_of_constrained_points == 110u);
  BOOST_TEST(report.number_of_moved_points + report.number_of_points_without_noise +
                 report.number_of_points_at_rest ==
             noisy.size() - 110);
}

BOOST_AUTO_TEST_CASE(several_blocks_and_one_give_the_same_counts)
{
  Points points = with_duplicates(noisy_cube(16));
  for (const auto& p : shapes::disc(1000)) // without noise
    points.emplace_back(p.x() + 10., p.y(), p.z());
  const std::vector<std::size_t> whole = counts(smooth(points, np::update_period(4)));
  for (const unsigned int block_size : {1u, 1024u})
    BOOST_TEST(counts(smooth(points, np::block_size(block_size))) == whole,
               boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_canceled_run_leaves_the_report_unchanged)
{
  Points points = noisy_cube(12);
  Smoothing_report report;
  report.number_of_points = 77;
  CGAL::balanced_flow_smooth_point_set<Sequential>(
      points,
      np::smoothing_report(std::ref(report)).callback([](double share) { return share < .5; }));
  BOOST_TEST(report.number_of_points == 77u);

  const Smoothing_report canceled = analyze_point_set<Sequential>(
      points, np::update_period(4).callback([](double) { return false; }));
  BOOST_TEST(std::isnan(canceled.noise));
  BOOST_TEST(std::isnan(canceled.spacing));
  BOOST_TEST(canceled.number_of_points == 0u);
}
