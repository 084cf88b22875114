// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_TEST_LEARNED_H
#define CGAL_POINT_SET_FLOW_TEST_LEARNED_H

#include "shapes.h"

#include <CGAL/Point_set_flow/Learned_curvature.h>
#include <CGAL/balanced_flow_smooth_point_set.h>

#include <boost/test/unit_test.hpp>

#include <random>
#include <vector>

// What is learned: symmetries and bounds that hold whatever the weights are, and that it is better than without.
namespace learned {

using namespace CGAL::Point_set_flow;
using shapes::Points;

/// A random neighborhood of the first point, with all that the estimator may ask for
struct Case {
  Points points;
  std::vector<std::uint32_t> others;
  std::vector<Compact_vector_3> normals;
  std::vector<float> residuals;
  std::vector<Compact_length> radii;
  std::vector<Sheet_evidence> sheets;
  double deviation, excess;

  explicit Case(unsigned int seed)
  {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    const std::size_t n = 3 + random() % 60;
    const double thickness = .1 * double(seed % 5);
    deviation = .1 + thickness;
    excess = normal(random) - 1.;
    for (std::size_t i = 0; i < n; ++i) {
      points.emplace_back(normal(random), normal(random), thickness * normal(random));
      const Vector_3 v(.3 * normal(random), .3 * normal(random), i % 3 == 0 ? 1. : -1.);
      normals.push_back(v / std::sqrt(v.squared_length()));
      residuals.push_back(float(.1 * normal(random)));
      sheets.push_back({float(normal(random)), float(normal(random))});
      if (i > 0)
        others.push_back(std::uint32_t(i));
    }
    normals.emplace_back(); // see `Surface_estimate_3::normals`
    radii.assign(n, Compact_length(radius()));
  }
  Surface_estimate_3 surface() const
  {
    Surface_estimate_3 s;
    s.normals = normals.data();
    s.noise = .1, s.spacing = .5, s.time = 1.;
    s.residuals = residuals.data();
    s.radii = radii.data();
    s.sheets = sheets.data();
    s.deviation = deviation, s.excess = excess;
    return s;
  }
  double radius() const
  {
    double squared = 0.;
    for (const Point_3& p : points)
      squared = (std::max)(squared, CGAL::squared_distance(points[0], p));
    return std::sqrt(squared);
  }
  Neighborhood_3 neighborhood() const
  {
    return {points.data(), 0, others.data(), others.size(), radius(), .6, surface()};
  }
};

inline Case turned(Case c)
{
  for (std::size_t i = 0; i < c.points.size(); ++i) {
    c.normals[i] = -c.normals[i].vector();
    c.residuals[i] = -c.residuals[i];
    c.sheets[i].side = -c.sheets[i].side;
  }
  return c;
}

/// Points in two square sheets that are so many deviations of the noise apart; z = 0 is in the middle.
inline Points noisy_wall(double distance, double noise)
{
  Points points;
  std::mt19937 random(5);
  std::normal_distribution<double> normal(0., noise);
  std::uniform_real_distribution<double> jitter(-.4, .4);
  for (int i = 0; i < 50; ++i)
    for (int j = 0; j < 50; ++j)
      for (const double z : {-.5, .5}) {
        const double x = i + jitter(random), y = j + jitter(random), dz = normal(random);
        points.emplace_back(x + normal(random), y + normal(random), z * distance * noise + dz);
      }
  return points;
}

template <typename Curvature, typename Error>
double rms_after(Points points, const Error& error)
{
  CGAL::balanced_flow_smooth_point_set<CGAL::Parallel_if_available_tag>(
      points, CGAL::parameters::curvature(Curvature()));
  double sum = 0.;
  for (const Point_3& p : points)
    sum += error(p) * error(p);
  return std::sqrt(sum / double(points.size()));
}

BOOST_AUTO_TEST_SUITE(what_is_learned)

BOOST_AUTO_TEST_CASE(the_movement_is_exactly_odd_in_the_normals)
{
  const Learned_curvature curvature;
  for (unsigned int seed = 0; seed < 50; ++seed) {
    const Case one(seed), other = turned(one);
    BOOST_TEST(curvature.correction(one.neighborhood(), 0) ==
               -curvature.correction(other.neighborhood(), 0));
    for (unsigned int round = 0; round < Learned_curvature::number_of_sheet_rounds; ++round) {
      const Sheet_evidence a = curvature.find_sheets(one.neighborhood(), round),
                           b = curvature.find_sheets(other.neighborhood(), round);
      BOOST_TEST(a.two_sheets == b.two_sheets);
      BOOST_TEST(a.side == -b.side);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_correction_follows_scaling_and_is_bounded)
{
  const Learned_curvature curvature;
  for (unsigned int seed = 0; seed < 50; ++seed) {
    Case c(seed);
    const double before = curvature.correction(c.neighborhood(), 0);
    double most = 0.;
    for (const float r : c.residuals)
      most = (std::max)(most, double(std::abs(r)) * c.radius());
    BOOST_TEST(std::abs(before) <= 2. * (std::max)(most, .001 * c.radius()));
    const double factor = std::ldexp(1., 20);
    for (Point_3& p : c.points)
      p = CGAL::ORIGIN + factor * (p - CGAL::ORIGIN);
    for (Compact_length& r : c.radii)
      r = Compact_length(factor * r.value());
    Surface_estimate_3 surface = c.surface();
    surface.noise *= factor, surface.spacing *= factor;
    const Neighborhood_3 larger(c.points.data(), 0, c.others.data(), c.others.size(), c.radius(),
                                .6, surface);
    BOOST_TEST(curvature.correction(larger, 0) == factor * before);
  }
}

BOOST_AUTO_TEST_CASE(points_without_noise_are_not_corrected)
{
  namespace np = CGAL::parameters;
  Points points = shapes::noisy_cube(), others = points;
  CGAL::balanced_flow_smooth_point_set<CGAL::Sequential_tag>(
      points, np::noise(0.).curvature(Learned_curvature()));
  CGAL::balanced_flow_smooth_point_set<CGAL::Sequential_tag>(
      others, np::noise(0.).curvature(Tangent_plane_curvature()));
  BOOST_TEST((points == others));
}

BOOST_AUTO_TEST_CASE(a_cube_comes_closer_to_its_faces_than_without)
{
  const Points points = shapes::noisy_cube(24, .03);
  const auto error = [](const Point_3& p) { return shapes::distance_to_cube(p); };
  const double with = rms_after<Learned_curvature>(points, error),
               without = rms_after<Tangent_plane_curvature>(points, error);
  BOOST_TEST(with < .95 * without);
}

BOOST_AUTO_TEST_CASE(the_sheets_of_a_wall_do_not_come_together)
{
  for (const double noise : {.5, .8}) {
    const double distance = 3.5; // in deviations
    const Points points = noisy_wall(distance, noise);
    const auto error = [&](const Point_3& p) { return std::abs(p.z()) - .5 * distance * noise; };
    const double with = rms_after<Learned_curvature>(points, error),
                 without = rms_after<Tangent_plane_curvature>(points, error);
    BOOST_TEST_MESSAGE("noise " << noise << ": " << with << ", without " << without);
    BOOST_TEST(with < .5 * noise);
    BOOST_TEST(with <= 1.02 * without);
  }
}

BOOST_AUTO_TEST_SUITE_END()

} // namespace learned

#endif // CGAL_POINT_SET_FLOW_TEST_LEARNED_H
