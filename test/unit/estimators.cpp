// SPDX-License-Identifier: GPL-3.0-or-later
// The curvature estimators, against known answers and against CGAL.
#define BOOST_TEST_MODULE estimators
#include <boost/test/unit_test.hpp>

#include "learned.h"
#include "shapes.h"

#include <CGAL/Aff_transformation_3.h>
#include <CGAL/Point_set_flow/Diffusivity.h>
#include <CGAL/balanced_flow_smooth_point_set.h>
#include <CGAL/jet_smooth_point_set.h>

#include <functional>
#include <numeric>

using namespace CGAL::Point_set_flow;
using shapes::Points;

namespace {

/// All points as one neighborhood of the first of them
struct All_of {
  const Points& points;
  std::vector<std::uint32_t> others;
  double radius;

  explicit All_of(const Points& p, double r = 1.) : points(p), others(p.size() - 1), radius(r)
  {
    std::iota(others.begin(), others.end(), 1u);
  }
  Neighborhood_3 neighborhood(const Surface_estimate_3& surface = Surface_estimate_3()) const
  {
    return Neighborhood_3(points.data(), 0, others.data(), others.size(), radius, .3, surface);
  }
};

CGAL::Aff_transformation_3<Core_kernel> some_rotation()
{
  const double a = .7, b = 1.9, ca = std::cos(a), sa = std::sin(a), cb = std::cos(b),
               sb = std::sin(b);
  return CGAL::Aff_transformation_3<Core_kernel>(ca * cb, -sa, ca * sb, sa * cb, ca, sa * sb, -sb,
                                                 0., cb);
}

Points lifted(Points disc, const std::function<double(double, double)>& height)
{
  for (Point_3& p : disc)
    p = Point_3(p.x(), p.y(), height(p.x(), p.y()));
  return disc;
}

} // namespace

BOOST_AUTO_TEST_CASE(a_plane_has_its_normal_and_no_variation)
{
  const auto rotation = some_rotation();
  Points points = shapes::disc(50);
  for (Point_3& p : points)
    p = rotation(p);
  const Tangent_plane_3 c = Covariance_curvature().tangent_plane(All_of(points).neighborhood());
  BOOST_TEST(std::abs(c.normal * rotation(Vector_3(0, 0, 1))) > 1. - 1e-14);
  BOOST_TEST(c.variation < 1e-15);
}

// Height h = rho^2 / 2R over a disc of radius r: the variance of h is r^4 / 48 R^2, that of a
// cylinder r^4 / 64 R^2, and the other two variances are r^2 / 4 each.
BOOST_AUTO_TEST_CASE(the_variation_of_sphere_and_cylinder_is_known)
{
  const double R = 20.;
  const Points sphere = lifted(
      shapes::disc(5000), [&](double x, double y) { return R - std::sqrt(R * R - x * x - y * y); });
  const Points cylinder =
      lifted(shapes::disc(5000), [&](double x, double) { return R - std::sqrt(R * R - x * x); });
  const Covariance_curvature curvature;
  BOOST_TEST(curvature.tangent_plane(All_of(sphere).neighborhood()).variation == 1. / (24. * R * R),
             boost::test_tools::tolerance(.01));
  BOOST_TEST(curvature.tangent_plane(All_of(cylinder).neighborhood()).variation ==
                 1. / (32. * R * R),
             boost::test_tools::tolerance(.01));
}

BOOST_AUTO_TEST_CASE(a_crease_has_the_bisecting_normal_and_the_variation_of_its_angle)
{
  for (const double angle : {5., 30., 60., 90., 120.}) {
    const double half = angle * CGAL_PI / 360.;
    Points points = shapes::disc(5000); // folded along the y axis
    for (Point_3& p : points)
      p = Point_3(p.x() * std::cos(half), p.y(), -std::abs(p.x()) * std::sin(half));
    const Tangent_plane_3 c = Covariance_curvature().tangent_plane(All_of(points).neighborhood());
    BOOST_TEST(c.variation == crease_variation(angle), boost::test_tools::tolerance(.01));
    if (angle <= 90.) // steeper creases have their least variance across
      BOOST_TEST(std::abs(c.normal.z()) > .999);
  }
}

BOOST_AUTO_TEST_CASE(equation_3_tells_the_side)
{
  Points points = shapes::disc(100);
  points[0] = Point_3(0, 0, .1); // above the plane
  const Vector_3 up(0, 0, 1);
  const All_of all(points);
  const Neighborhood_3 above = all.neighborhood();
  BOOST_TEST(Covariance_curvature::direction(above, up) == .1, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(Covariance_curvature::direction(above, -up) == -.1,
             boost::test_tools::tolerance(1e-9));

  // whatever side the normal has, -curvature * normal leads back to the surface
  const auto motion = [](const Neighborhood_3& neighborhood) {
    const Tangent_plane_3 plane = Covariance_curvature().tangent_plane(neighborhood);
    return -Covariance_curvature().directional_curvature(neighborhood, plane) * plane.normal;
  };
  BOOST_TEST(motion(above).z() < 0.);

  // and on a sphere to its inside
  const Points cap =
      lifted(shapes::disc(100), [](double x, double y) { return -.1 * (x * x + y * y); });
  const All_of all_of_cap(cap);
  BOOST_TEST(motion(all_of_cap.neighborhood()).z() < 0.);
}

BOOST_AUTO_TEST_CASE(the_variation_is_accurate_where_it_is_tiny_and_where_eigenvalues_meet)
{
  const auto rotation = some_rotation();
  for (const double e : {1e-1, 1e-2, 1e-3, 1e-4}) {
    Points points = {{0, 0, 0}, {1, 0, e}, {-1, 0, e}, {0, 1, -e}, {0, -1, -e}};
    for (Point_3& p : points)
      p = rotation(p);
    BOOST_TEST(Covariance_curvature().tangent_plane(All_of(points).neighborhood()).variation ==
                   e * e / (1. + e * e),
               boost::test_tools::tolerance(1e-6));
  }
  const Points octahedron = {{0, 0, 0},  {1, 0, 0}, {-1, 0, 0}, {0, 1, 0},
                             {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  const Tangent_plane_3 c = Covariance_curvature().tangent_plane(All_of(octahedron).neighborhood());
  BOOST_TEST(c.variation == 1. / 3., boost::test_tools::tolerance(1e-14));
  BOOST_TEST(c.normal.squared_length() == 1., boost::test_tools::tolerance(1e-14));

  const Points one_place(4, Point_3(1, 2, 3));
  const All_of all_of_place(one_place, 0.);
  const Neighborhood_3 place = all_of_place.neighborhood();
  const Tangent_plane_3 none = Covariance_curvature().tangent_plane(place);
  BOOST_TEST(none.variation == 0.);
  BOOST_TEST(Covariance_curvature().directional_curvature(place, none) == 0.);
  BOOST_TEST(none.normal.squared_length() == 1.);
}

// ---- the tangent plane curvature

namespace {
/// The directional curvature where the normals are known
double tangent_plane_curvature(const Neighborhood_3& neighborhood)
{
  const Tangent_plane_curvature curvature;
  return curvature.directional_curvature(neighborhood, curvature.tangent_plane(neighborhood));
}

/// The surface of which the normals, and one more, are known, with noise of a tenth of the spacing, at the end
Surface_estimate_3 with_normals(const std::vector<Compact_vector_3>& normals)
{
  Surface_estimate_3 surface;
  surface.normals = normals.data();
  surface.noise = .01;
  surface.spacing = .1;
  surface.time = 1.;
  return surface;
}
} // namespace

BOOST_AUTO_TEST_CASE(a_sphere_does_not_shrink)
{
  const double R = 3.;
  const Points cap = lifted(
      shapes::disc(300), [&](double x, double y) { return std::sqrt(R * R - x * x - y * y) - R; });
  std::vector<Compact_vector_3> normals;
  for (const Point_3& p : cap)
    normals.push_back(Vector_3(p.x(), p.y(), p.z() + R) / R * (normals.size() % 2 ? 1. : -1.));
  normals.emplace_back();
  const All_of all(cap);
  const Neighborhood_3 neighborhood = all.neighborhood(with_normals(normals));
  BOOST_TEST(std::abs(tangent_plane_curvature(neighborhood)) < 1e-7); // of `float`
  BOOST_TEST(std::abs(Covariance_curvature::direction(neighborhood, normals[0].vector())) > 1e-3);
}

BOOST_AUTO_TEST_CASE(the_other_side_of_a_crease_and_another_sheet_do_not_pull)
{
  // a plane, with its middle at a distance of 0.05 from a crease of 90 degrees, and another sheet
  // ten times the noise below
  Points points = shapes::disc(1000);
  std::vector<Compact_vector_3> normals(points.size() + 1, Vector_3(0, 0, 1));
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double beyond = points[i].x() - .05;
    if (beyond > 0.) {
      points[i] = Point_3(.05, points[i].y(), -beyond);
      normals[i] = Vector_3(1, 0, 0);
    }
    else if (i % 3 == 0) {
      points[i] = Point_3(points[i].x(), points[i].y(), -.1);
      normals[i] = Vector_3(0, 0, -1);
    }
  }
  const All_of all(points);
  const Neighborhood_3 neighborhood = all.neighborhood(with_normals(normals));
  BOOST_TEST(std::abs(tangent_plane_curvature(neighborhood)) < 1e-4);
  BOOST_TEST(Covariance_curvature::direction(neighborhood, normals[0].vector()) > .01);
  const Tangent_plane_3 plane = Tangent_plane_curvature().tangent_plane(neighborhood);
  BOOST_TEST(std::abs(plane.normal.z()) > .999);
  BOOST_TEST(plane.variation < 1e-3);
}

BOOST_AUTO_TEST_CASE(a_point_off_the_plane_comes_back_by_at_most_the_width_of_the_noise)
{
  Points points = shapes::disc(300);
  const std::vector<Compact_vector_3> normals(points.size() + 1, Vector_3(0, 0, 1));
  for (const double height : {.002, .01, .5}) {
    points[0] = Point_3(0, 0, height);
    const All_of all(points);
    Surface_estimate_3 surface = with_normals(normals);
    surface.time = 0.;
    const double back = tangent_plane_curvature(all.neighborhood(surface));
    if (height < .1)
      BOOST_TEST(back == height, boost::test_tools::tolerance(1e-4));
    else
      BOOST_TEST(back == .018, boost::test_tools::tolerance(1e-9));
  }
}

BOOST_AUTO_TEST_CASE(by_default_the_result_is_nearer_to_the_truth_than_that_of_jet_smoothing)
{
  for (const double sigma : {.01, .03}) {
    const Points noisy = shapes::noisy_cube(30, sigma);
    Points ours = noisy, jet = noisy;
    CGAL::balanced_flow_smooth_point_set<CGAL::Sequential_tag>(ours);
    CGAL::jet_smooth_point_set<CGAL::Sequential_tag>(jet, 24);
    const double error = shapes::rms(ours, shapes::distance_to_cube);
    BOOST_TEST(error < .8 * shapes::rms(jet, shapes::distance_to_cube));
    BOOST_TEST(error < .5 * shapes::rms(noisy, shapes::distance_to_cube));
  }
  Points sphere = shapes::sphere(5000, 1.);
  shapes::add_noise(sphere, .03);
  const double before = shapes::mean_radius(sphere);
  CGAL::balanced_flow_smooth_point_set<CGAL::Sequential_tag>(sphere);
  BOOST_TEST(std::abs(shapes::mean_radius(sphere) - before) < .003);
}

BOOST_AUTO_TEST_CASE(clean_points_are_left_alone)
{
  const double spacing = std::sqrt(24. / (6. * 40. * 40.));
  const Points clean = shapes::cube(40);
  Points points = clean;
  CGAL::balanced_flow_smooth_point_set<CGAL::Sequential_tag>(points);
  double sum = 0.;
  for (std::size_t i = 0; i < points.size(); ++i)
    sum += CGAL::squared_distance(points[i], clean[i]);
  BOOST_TEST(std::sqrt(sum / double(points.size())) < .05 * spacing);

  const Points plane = shapes::disc(500);
  points = plane;
  CGAL::balanced_flow_smooth_point_set<CGAL::Sequential_tag>(points);
  BOOST_TEST((points == plane)); // bitwise
}
