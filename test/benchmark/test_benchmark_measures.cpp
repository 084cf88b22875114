// SPDX-License-Identifier: GPL-3.0-or-later
// The measures of benchmark_field, where the right answer is known
#define BOOST_TEST_MODULE benchmark_measures
#include "field/run_field.h"
#include "punet/Punet_case.h"
#include "relief/Building_relief.h"
#include "scanner/Virtual_scanner.h"
#include "scanner/building_front.h"

#include <boost/test/unit_test.hpp>

namespace comparison {

namespace {

Points random_points(std::size_t n, unsigned int seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1., 1.);
  Points points;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = unit(random), y = unit(random);
    points.emplace_back(x, y, unit(random));
  }
  return points;
}

} // namespace

BOOST_AUTO_TEST_CASE(waves_are_closest_along_their_normal)
{
  const Wave_surface waves(20., 3);
  for (const Point_3& p : random_points(100, 1)) {
    const double x = 50. * p.x(), y = 50. * p.y();
    const double d = p.z(); // the radius of curvature is at least 10
    const Surface_point found = waves.closest(waves.point(x, y) + d * waves.normal(x, y));
    BOOST_TEST(std::abs(found.signed_distance - d) < 1e-9);
    BOOST_TEST(std::sqrt(CGAL::squared_distance(found.point, waves.point(x, y))) < 1e-6);
  }
}

BOOST_AUTO_TEST_CASE(field_clouds_have_the_noise_that_they_say)
{
  for (const auto& make : field_cloud_makers({3000, 1., 1., 7})) {
    const Test_cloud cloud = make(), same = make();
    BOOST_TEST(cloud.points.size() > 2700u);
    BOOST_TEST(cloud.points.size() < 3300u);
    BOOST_TEST((cloud.points == same.points));
    const double error = cloud.error_of(cloud.points) / cloud.spacing;
    BOOST_TEST(error > .02, cloud.name);
    BOOST_TEST(error < .5, cloud.name);
  }
}

BOOST_AUTO_TEST_CASE(faces_find_their_nearest_point)
{
  const Points points = random_points(300, 1), corners = random_points(90, 2);
  const Nearest_points nearest(points);
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    const Kernel::Triangle_3 triangle(corners[i], corners[i + 1], corners[i + 2]);
    double least = std::numeric_limits<double>::infinity();
    for (const Point_3& p : points)
      least = (std::min)(least, CGAL::squared_distance(p, triangle));
    const double found =
        Face_distance(points, nearest, {corners[i], corners[i + 1], corners[i + 2]}).squared();
    BOOST_TEST(found == least);
  }
}

BOOST_AUTO_TEST_CASE(scores_of_a_shifted_plane_are_known)
{
  Punet_case square;
  const Points corners = {{0., 0., 0.}, {1., 0., 0.}, {1., 1., 0.}, {0., 1., 0.}};
  square.surface = std::make_shared<Mesh_surface>(*make_mesh(corners, {{0, 1, 2}, {0, 2, 3}}));
  const int m = 20;
  for (int i = 0; i <= m; ++i)
    for (int j = 0; j <= m; ++j)
      square.clean.emplace_back(double(i) / m, double(j) / m, 0.);
  Points shifted, without_corner;
  for (const Point_3& p : square.clean) {
    shifted.emplace_back(p.x(), p.y(), .01);
    if (p.x() > .09 || p.y() > .09)
      without_corner.push_back(p);
  }
  const Punet_score none = square.score(square.clean, ""), score = square.score(shifted, "");
  BOOST_TEST(none.cd + none.p2m + none.rms + none.variation + none.gap < 1e-6);
  BOOST_TEST(std::abs(score.cd - 2.) < 1e-6); // .01^2 in both directions, x 1e4
  BOOST_TEST(std::abs(score.p2m - 2.) < 1e-6);
  BOOST_TEST(std::abs(score.rms - 10.) < 1e-6); // x 1e3
  BOOST_TEST(std::abs(score.gap - .2) < 1e-6);  // spacings of .05
  BOOST_TEST(std::abs(square.score(without_corner, "").gap - 2.) < 1e-6);
}

BOOST_AUTO_TEST_CASE(relief_is_what_is_left_of_the_heights)
{
  // pilasters of .3 on a wall, in a frame that is turned
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0., 1.);
  std::normal_distribution<double> noise(0., .003);
  const double c = std::cos(.4), s = std::sin(.4);
  const auto wall = [&](double u, double z, double w) {
    return Point_3(c * u - s * w, s * u + c * w, z);
  };
  Points input, half;
  for (int i = 0; i < 20000; ++i) {
    const double u = 20. * unit(random), z = 6. * unit(random), w = noise(random);
    const double step = std::fmod(u, 4.) < 1. ? .3 : 0.;
    input.push_back(wall(u, z, step + w));
    half.push_back(wall(u, z, .5 * step + w / 4.));
  }
  const Building_relief relief(input);
  BOOST_TEST(relief.number_of_steps() > 50u);
  BOOST_TEST(relief.number_of_flat_patches() > 50u);
  BOOST_TEST(std::abs(relief.relief_kept(input).mean - 1.) < 1e-12);
  BOOST_TEST(std::abs(relief.relief_kept(half).mean - .5) < .01);
  BOOST_TEST(std::abs(relief.roughness(input) - .003) < .0005);
  BOOST_TEST(std::abs(relief.roughness(half) / relief.roughness(input) - .25) < .01);
}

BOOST_AUTO_TEST_CASE(clean_scans_lie_on_the_mesh)
{
  Scan_scene scene;
  scene.surface = std::make_shared<Mesh_surface>(*building_front(.02, 1));
  scene.positions = {Point_3(-.9, -2.5, -.5), Point_3(.9, -2.5, -.5)};
  Scan_settings settings;
  const Test_cloud clean = Virtual_scanner(scene, settings, 1)(2000);
  BOOST_TEST(std::abs(double(clean.points.size()) - 2000.) < 200.);
  BOOST_TEST(clean.error_of(clean.points) < 1e-9);
  settings.noise = .5;
  settings.gives_normals = true;
  const Test_cloud noisy = Virtual_scanner(scene, settings, 1)(2000);
  BOOST_TEST(noisy.error_of(noisy.points) > .3 * noisy.spacing);
  BOOST_TEST(noisy.error_of(noisy.points) < .5 * noisy.spacing);
  for (const Vector_3& n : noisy.normals)
    BOOST_TEST_REQUIRE(std::abs(n.squared_length() - 1.) < 1e-6);
  settings = Scan_settings();
  settings.registration = .5;
  const Test_cloud moved = Virtual_scanner(scene, settings, 1)(2000);
  BOOST_TEST(moved.error_of(moved.points) > .05 * moved.spacing);
  BOOST_TEST(moved.error_of(moved.points) < 1.5 * moved.spacing);
}

} // namespace comparison
