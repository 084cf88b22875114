// SPDX-License-Identifier: GPL-3.0-or-later
// The measuring instruments of compare_smoothers and benchmark_accuracy, on shapes with known
// answers: figures are worth what these are.
#define BOOST_TEST_MODULE measures
#include "benchmark/Apss.h"
#include "benchmark/Benchmark_shapes.h"
#include "shapes.h"

#include "measure/Noise_models.h"
#include "measure/Smoothing_measures.h"
#include "measure/sample_mesh.h"

#include <boost/test/unit_test.hpp>

using namespace comparison;

namespace {

/// Points all around the surface, inside and outside
Points random_points(std::size_t n, double half_width)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> coordinate(-half_width, half_width);
  Points points;
  while (points.size() < n) {
    const double x = coordinate(random), y = coordinate(random), z = coordinate(random);
    points.emplace_back(x, y, z);
  }
  return points;
}

std::optional<Mesh> cube_mesh() // of half side 1/sqrt(3)
{
  return prism({{-1., -1.}, {1., -1.}, {1., 1.}, {-1., 1.}}, 2.);
}

} // namespace

BOOST_AUTO_TEST_CASE(signed_distances_to_a_cube_are_exact)
{
  const Mesh_surface cube(*cube_mesh());
  const double half = 1. / std::sqrt(3.);
  BOOST_TEST(cube.area() == 24. * half * half, boost::test_tools::tolerance(1e-12));
  for (const Point_3& p : random_points(2000, 1.)) {
    const Point_3 scaled = CGAL::ORIGIN + (p - CGAL::ORIGIN) / half;
    const double distance = half * shapes::distance_to_cube(scaled);
    const bool outside = (std::max)({std::abs(p.x()), std::abs(p.y()), std::abs(p.z())}) > half;
    const Surface_point closest = cube.closest(p);
    BOOST_TEST(closest.signed_distance - (outside ? distance : -distance) == 0.,
               boost::test_tools::tolerance(1e-12) << "at " << p);
    BOOST_TEST(std::abs(closest.normal.squared_length() - 1.) < 1e-12);
  }
  BOOST_TEST(std::abs(cube.distance_to_sharp_edge(CGAL::ORIGIN) - std::sqrt(2.) * half) < 1e-12);
}

// A prism over an L has a concave edge, and vertices with concave and convex edges
BOOST_AUTO_TEST_CASE(the_sides_of_a_concave_shape_are_right)
{
  const Mesh_surface shape(
      *prism({{-1., -1.}, {1., -1.}, {1., 0.}, {0., 0.}, {0., 1.}, {-1., 1.}}, 1.));
  const double scale = shape.mesh().point(*shape.mesh().vertices().begin()).x() / -1.;
  for (const Point_3& p : random_points(2000, 1.)) {
    const double x = p.x() / scale, y = p.y() / scale, z = p.z() / scale;
    const bool inside =
        (std::max)({std::abs(x), std::abs(y), 2. * std::abs(z)}) < 1. && !(x > 0. && y > 0.);
    BOOST_TEST((shape.closest(p).signed_distance < 0.) == inside, "at " << p);
  }
}

BOOST_AUTO_TEST_CASE(samples_have_blue_noise)
{
  const Mesh_surface cube(*cube_mesh());
  const std::size_t n = 2000;
  const Samples samples = sample_mesh(cube, n, 1);
  BOOST_TEST(samples.points.size() == n);
  BOOST_TEST(Surface_errors(samples.points, cube, std::vector<char>(n, false)).all.max() < 1e-12);
  BOOST_TEST(spacing(samples.points).variation < .15); // of random points: .5
  for (std::size_t i = 0; i < n; ++i) {
    const double half = 1. / std::sqrt(3.);
    BOOST_TEST(std::abs(samples.normals[i] * (samples.points[i] - CGAL::ORIGIN) - half) < 1e-12);
  }

  // four fifths of the way up, the density is 10^-0.8 of that at the bottom
  const Samples dense = sample_mesh(cube, n, 1, tenfold_density);
  const auto in_slab = [&](double low, double high) {
    return std::count_if(dense.points.begin(), dense.points.end(),
                         [&](const Point_3& p) { return p.y() >= low && p.y() < high; });
  };
  const double ratio = double(in_slab(-.5, -.4)) / double(in_slab(.4, .5));
  BOOST_TEST(ratio > .75 * std::pow(10., .45));
  BOOST_TEST(ratio < 1.33 * std::pow(10., .45));
}

BOOST_AUTO_TEST_CASE(noise_has_its_deviation)
{
  const Points origin(20000, CGAL::ORIGIN);
  for (const char* model : {"Gaussian", "uniform", "Laplace", "varying"}) {
    const double rms = movement(origin, add_noise(origin, model, .01, 5).points);
    BOOST_TEST(rms == .01 * std::sqrt(3.), boost::test_tools::tolerance(.03) << model);
  }
  BOOST_TEST(movement(origin, add_noise(origin, "directional", .01, 5).points) == .01,
             boost::test_tools::tolerance(.03));
  const Noisy_points with_outliers = add_noise(origin, "outliers", .01, 5);
  BOOST_TEST(double(inliers(with_outliers, origin).size()) == .98 * 20000.,
             boost::test_tools::tolerance(.01));
  BOOST_TEST(movement(inliers(with_outliers, origin),
                      inliers(with_outliers, with_outliers.points)) == .01 * std::sqrt(3.),
             boost::test_tools::tolerance(.03));
}

BOOST_AUTO_TEST_CASE(the_measures_of_a_moved_plane_are_known)
{
  const Points from = shapes::disc(1000);
  Points to;
  for (const Point_3& p : from)
    to.push_back(p + Vector_3(.003, .004, .012));
  const Vectors up(from.size(), Vector_3(0., 0., 1.)), down(from.size(), Vector_3(0., 0., -1.)),
      tilted(from.size(), Vector_3(std::sin(.1), 0., std::cos(.1)));
  BOOST_TEST(std::abs(movement(from, to) - .013) < 1e-12);
  BOOST_TEST(std::abs(tangential_drift(from, to, up) - .005) < 1e-12);
  BOOST_TEST(std::abs(chamfer_distance(to, from) - 2. * .013 * .013) < 1e-10);
  BOOST_TEST(normal_error(up, down) < 1e-9);
  BOOST_TEST(std::abs(normal_error(up, tilted) - .1 * 180. / CGAL_PI) < 1e-9);
  BOOST_TEST(roughness(from) < 1e-12);
}

BOOST_AUTO_TEST_CASE(apss_keeps_spheres_and_planes)
{
  const Points sphere = shapes::sphere(2000, 2.);
  Vectors normals;
  for (const Point_3& p : sphere)
    normals.push_back((p - CGAL::ORIGIN) / 2.);
  BOOST_TEST(movement(sphere, apss(sphere, normals, 48).points) < 1e-6);
  const Points disc = shapes::disc(2000);
  BOOST_TEST(movement(disc, apss(disc, Vectors(2000, Vector_3(0., 0., 1.)), 48).points) < 1e-9);

  Points noisy = sphere;
  shapes::add_noise(noisy, .05);
  const auto distance = [](const Point_3& p) { return shapes::distance_to_origin(p) - 2.; };
  BOOST_TEST(shapes::rms(apss(noisy, normals, 48).points, distance) <
             .4 * shapes::rms(noisy, distance));
}
