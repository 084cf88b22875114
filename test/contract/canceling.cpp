// SPDX-License-Identifier: GPL-3.0-or-later
// What the callback is told, and that it can cancel.
#define BOOST_TEST_MODULE canceling
#include <boost/test/unit_test.hpp>

#include "shapes.h"

#include <CGAL/balanced_flow_smooth_point_set.h>
#include <boost/property_map/property_map.hpp>

#include <map>

namespace np = CGAL::parameters;
using namespace CGAL::Point_set_flow;
using shapes::noisy_cube;
using shapes::Points;
typedef CGAL::Sequential_tag Sequential;

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
  for (const std::size_t m : {8u, 40u}) {
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
    check_progress(m, np::number_of_relaxation_steps(4));
    check_progress(m, np::curvature(Covariance_curvature()));
    check_progress(m, np::curvature(Covariance_curvature()).flow(Curvature_flow()));
    check_progress(m, np::curvature(Covariance_curvature()).block_size(2048));
    check_progress(m, np::feature_strength_map(strength_map).normal_map(normal_map));
    check_progress(m,
                   np::feature_strength_map(strength_map).block_size(1024).normal_map(normal_map));
  }
}

BOOST_AUTO_TEST_CASE(a_canceled_run_changes_nothing)
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
