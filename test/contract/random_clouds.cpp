// SPDX-License-Identifier: GPL-3.0-or-later
// What holds for any finite points and any valid parameters, tried on thousands of random cases. A
// failure prints the seed of its case: test_random_clouds --run_test=... -- SEED runs that one alone.
#define BOOST_TEST_MODULE random_clouds
#include <boost/test/unit_test.hpp>

#include "random_clouds.h"

#include <CGAL/Point_set_flow/Any_flow.h>
#include <CGAL/balanced_flow_smooth_point_set.h>

#include <map>
#include <numeric>

namespace np = CGAL::parameters;
using namespace CGAL::Point_set_flow;
using random_clouds::Cloud;
using random_clouds::Point_3;
using random_clouds::Points;
typedef CGAL::Sequential_tag Sequential;

namespace {

double distance(const Point_3& p, const Point_3& q)
{
  return std::hypot(p.x() - q.x(), p.y() - q.y(), p.z() - q.z());
}

bool is_finite(const Point_3& p)
{
  return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
}

double largest_coordinate(const Points& points)
{
  double largest = 0.;
  for (const Point_3& p : points)
    largest = (std::max)({largest, std::abs(p.x()), std::abs(p.y()), std::abs(p.z())});
  return largest;
}

/// The distance of the k-th of the other places, or of the last one. What differs by so little of the extent
/// is one place.
double neighborhood_radius(const Points& points, std::size_t i, std::size_t k)
{
  const double same = 1e-140 * largest_coordinate(points);
  const auto rounded = [&](double c) { return std::abs(c) < same ? 0. : c; };
  std::vector<Point_3> places;
  for (const Point_3& p : points)
    places.emplace_back(rounded(p.x()), rounded(p.y()), rounded(p.z()));
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  std::vector<double> distances(places.size());
  std::transform(places.begin(), places.end(), distances.begin(),
                 [&](const Point_3& p) { return distance(p, points[i]); });
  std::sort(distances.begin(), distances.end());
  return distances[(std::min)(k, distances.size() - 1)];
}

template <typename Visit>
void for_each_seed(const Visit& visit, unsigned int count)
{
  const auto& suite = boost::unit_test::framework::master_test_suite();
  if (suite.argc > 1)
    return visit(static_cast<unsigned int>(std::stoul(suite.argv[1])));
  for (unsigned int seed = 1; seed <= count; ++seed)
    visit(seed);
}

/// Calls the function with a pack of named parameters, and k or not
template <typename Tag, typename Parameters>
double smooth(Points& points, unsigned int k, const Parameters& parameters)
{
  return k == 0 ? CGAL::balanced_flow_smooth_point_set<Tag>(points, parameters)
                : CGAL::balanced_flow_smooth_point_set<Tag>(points, k, parameters);
}

void check_result(const Cloud& cloud, const Points& result, double moved)
{
  BOOST_TEST(moved >= 0.);
  BOOST_TEST(std::isfinite(moved));
  std::map<Point_3, Point_3> became;
  for (std::size_t i = 0; i < result.size(); ++i) {
    BOOST_TEST(is_finite(result[i]));
    const auto [place, is_new] = became.emplace(cloud.points[i], result[i]);
    BOOST_TEST((is_new || place->second == result[i])); // duplicates stay equal
  }
}

/// No point is farther from where it was than its farthest neighbor
void check_neighborhoods(const Cloud& cloud, const Points& result, unsigned int k)
{
  const double rounding = 1e-12 * largest_coordinate(cloud.points);
  const std::size_t most = Tangent_plane_curvature::defaults().largest_size;
  for (std::size_t i = 0; i < result.size(); i += 7)
    BOOST_TEST(distance(result[i], cloud.points[i]) <=
               neighborhood_radius(cloud.points, i, k == 0 ? most : k) + rounding);
}

} // namespace

BOOST_AUTO_TEST_CASE(by_default_points_stay_in_their_neighborhoods)
{
  for_each_seed(
      [](unsigned int seed) {
        const Cloud cloud(seed);
        BOOST_TEST_CONTEXT("seed " << seed << ", " << cloud.kind << ", " << cloud.points.size()
                                   << " points")
        {
          Points points = cloud.points;
          const unsigned int k = cloud.chance(.5) ? 0 : cloud.number(2, 60);
          const double moved =
              smooth<Sequential>(points, k,
                                 np::number_of_iterations(cloud.chance(.5) ? 5 : cloud.number(0, 8))
                                     .number_of_relaxation_steps(seed % 4));
          check_result(cloud, points, moved);
          check_neighborhoods(cloud, points, k);
        }
      },
      3000);
}

namespace {
/// A flow of a user with another name, and nothing else
struct Derived_flow : Balanced_flow {};
} // namespace

BOOST_AUTO_TEST_CASE(derived_and_erased_flows_keep_points_in_their_neighborhoods)
{
  for_each_seed(
      [](unsigned int seed) {
        const Cloud cloud(seed);
        BOOST_TEST_CONTEXT("seed " << seed << ", " << cloud.kind << ", " << cloud.points.size()
                                   << " points")
        {
          const unsigned int k = cloud.chance(.5) ? 0 : cloud.number(2, 60);
          const auto run = [&](const auto& flow) { // so many steps that it matters
            Points points = cloud.points;
            const double moved = smooth<Sequential>(
                points, k, np::flow(flow).step_length(1.5).number_of_iterations(15));
            return std::make_pair(points, moved);
          };
          const auto expected = run(Balanced_flow());
          check_neighborhoods(cloud, expected.first, k);
          const auto check = [&](const auto& flow) { BOOST_TEST((run(flow) == expected)); };
          check(Derived_flow());
          check(Any_flow(Balanced_flow()));
          check(Any_flow(Derived_flow()));
        }
      },
      300);
}

BOOST_AUTO_TEST_CASE(threads_blocks_and_the_order_of_the_input_change_nothing)
{
  for_each_seed(
      [](unsigned int seed) {
        const Cloud cloud(seed);
        BOOST_TEST_CONTEXT("seed " << seed << ", " << cloud.kind << ", " << cloud.points.size()
                                   << " points")
        {
          const unsigned int k = cloud.chance(.5) ? 0 : cloud.number(2, 60);
          Points expected = cloud.points, in_blocks = expected, by_threads = expected, shuffled;
          const auto steps = np::number_of_iterations(2).number_of_relaxation_steps(seed % 3);
          smooth<Sequential>(expected, k, steps);
          smooth<Sequential>(in_blocks, k,
                             np::block_size(cloud.number(1, 50))
                                 .number_of_iterations(2)
                                 .number_of_relaxation_steps(seed % 3));
          BOOST_TEST((in_blocks == expected));
          smooth<CGAL::Parallel_if_available_tag>(by_threads, k, steps);
          BOOST_TEST((by_threads == expected));

          std::vector<std::size_t> order(expected.size());
          std::iota(order.begin(), order.end(), std::size_t(0));
          std::shuffle(order.begin(), order.end(), std::mt19937(seed));
          for (const std::size_t i : order)
            shuffled.push_back(cloud.points[i]);
          smooth<Sequential>(shuffled, k, steps);
          for (std::size_t i = 0; i < order.size(); ++i)
            BOOST_TEST((shuffled[i] == expected[order[i]]));

          Points canceled = cloud.points;
          const double stop_at = .01 * cloud.number(0, 100);
          const double moved = smooth<CGAL::Parallel_if_available_tag>(
              canceled, k, np::callback([=](double share) { return share < stop_at; }));
          BOOST_TEST((cloud.points.empty() || std::isnan(moved)));
          BOOST_TEST((canceled == cloud.points));
        }
      },
      400);
}

namespace {

template <typename Flow, typename Curvature>
void try_flow(unsigned int seed, const Flow& flow, const Curvature& curvature)
{
  const Cloud cloud(seed);
  BOOST_TEST_CONTEXT("seed " << seed << ", " << cloud.kind << ", " << cloud.points.size()
                             << " points")
  {
    Points points = cloud.points;
    const double extent = random_clouds::extent(points);
    const unsigned int k = cloud.chance(.3) ? 0 : cloud.number(2, 300);
    const double moved = smooth<Sequential>(
        points, k,
        np::flow(flow)
            .curvature(curvature)
            .update_period(cloud.number(0, 5))
            .step_length(.01 * cloud.number(1, 100))
            .filter_width(.01 * cloud.number(5, 200))
            .neighbor_radius(cloud.chance(.5) ? 0. : .01 * cloud.number(1, 100) * extent)
            .sharpness_angle(double(cloud.number(1, 180)))
            .number_of_relaxation_steps(seed % 4)
            .number_of_iterations(cloud.number(0, 30)));
    check_result(cloud, points, moved);
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(any_flow_and_parameters_give_finite_points)
{
  for_each_seed(
      [](unsigned int seed) {
        try_flow(seed, Balanced_flow(), Tangent_plane_curvature());
        try_flow(seed, Balanced_flow(), Covariance_curvature());
        try_flow(seed, Volume_preserving_flow(), Covariance_curvature());
        try_flow(seed, Curvature_flow(), Tangent_plane_curvature());
        try_flow(seed, Well_posed_anisotropic_flow(), Covariance_curvature());
      },
      400);
}

BOOST_AUTO_TEST_CASE(extreme_parameters_give_finite_points_or_an_error)
{
  for_each_seed(
      [](unsigned int seed) {
        const Cloud cloud(seed);
        const auto extreme = [&] {
          static const double values[] = {0., 5e-324, 1e-300, 1e-100, 1e-10, .5,
                                          1., 1.9,    1e10,   1e100,  1e308};
          return values[cloud.number(0, 10)];
        };
        BOOST_TEST_CONTEXT("seed " << seed << ", " << cloud.kind << ", " << cloud.points.size()
                                   << " points")
        {
          const auto attempt = [&](const auto& own) {
            Points points = cloud.points;
            try {
              const double moved = smooth<CGAL::Parallel_if_available_tag>(
                  points, cloud.chance(.5) ? 0 : cloud.number(2, 2147483647),
                  own.neighbor_radius(extreme())
                      .number_of_iterations(cloud.number(0, 4))
                      .number_of_relaxation_steps(seed % 3));
              check_result(cloud, points, moved);
            }
            catch (const std::overflow_error&) {
              BOOST_TEST((points == cloud.points));
            }
          };
          const auto run = [&](const auto& curvature) {
            const auto own = np::curvature(curvature)
                                 .step_length(extreme())
                                 .filter_width(extreme())
                                 .feature_threshold(extreme())
                                 .block_size(cloud.number(1, 300));
            if (cloud.chance(.5))
              attempt(own);
            else
              attempt(own.noise(extreme()));
          };
          run(Tangent_plane_curvature());
          run(Covariance_curvature());
        }
      },
      400);
}

BOOST_AUTO_TEST_CASE(bad_values_are_named_and_nothing_is_changed)
{
  for_each_seed(
      [](unsigned int seed) {
        Cloud cloud(seed);
        if (cloud.points.empty())
          return;
        BOOST_TEST_CONTEXT("seed " << seed)
        {
          const std::size_t where = cloud.number(0, unsigned(cloud.points.size() - 1));
          double c[3] = {1., 2., 3.};
          c[cloud.number(0, 2)] = cloud.chance(.3)   ? std::numeric_limits<double>::quiet_NaN()
                                  : cloud.chance(.5) ? std::numeric_limits<double>::infinity()
                                                     : -std::numeric_limits<double>::infinity();
          cloud.points[where] = Point_3(c[0], c[1], c[2]);
          Points points = cloud.points;
          BOOST_CHECK_EXCEPTION(
              smooth<CGAL::Parallel_if_available_tag>(points, 0, np::number_of_iterations(2)),
              std::invalid_argument, [&](const std::exception& error) {
                return std::string(error.what()).find("points[" + std::to_string(where) + "] is") !=
                       std::string::npos;
              });
          for (std::size_t i = 0; i < points.size(); ++i)
            BOOST_TEST((i == where || points[i] == cloud.points[i]));
        }
      },
      200);
}
