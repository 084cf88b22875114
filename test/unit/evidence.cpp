// SPDX-License-Identifier: GPL-3.0-or-later
// What neighborhoods tell on given sides and on scans, against known answers.
#define BOOST_TEST_MODULE evidence
#include <boost/test/unit_test.hpp>

#include "shapes.h"

#include <CGAL/Point_set_flow/internal/fitting/Quadric_fit.h>
#include <CGAL/Point_set_flow/internal/fitting/scan_evidence.h>
#include <CGAL/Point_set_flow/internal/fitting/side_evidence.h>
#include <CGAL/Point_set_flow/internal/order/Point_buffer.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <random>

using namespace CGAL::Point_set_flow;
namespace internal = CGAL::Point_set_flow::internal;

namespace {

const double sigma = .05; // of the noise; the patches have a radius of 1

/// A patch of a plane in any position, with noise, the middle first; its points are moved along the normal.
struct Patch {
  internal::Array<Point_3> points;
  internal::Array<Vector_3> sides;
  internal::Array<std::uint32_t> scans;
  std::vector<std::uint32_t> neighbors; // all but the first

  /// \param n the number of points, each in one of two layers, at random
  /// \param distance between the layers
  Patch(std::size_t n, double distance, std::mt19937& random, bool has_opposite_sides = false)
  {
    std::normal_distribution<double> gauss(0., 1.);
    const Vector_3 across = unit(Vector_3(gauss(random), gauss(random), gauss(random)));
    const Vector_3 e1 =
        unit(CGAL::cross_product(across, Vector_3(gauss(random), gauss(random), 1.)));
    const Vector_3 e2 = CGAL::cross_product(across, e1);
    for (const auto& p : shapes::disc(n)) {
      const std::uint32_t layer = std::uint32_t(random() % 2);
      const double height = sigma * gauss(random) + (layer - .5) * distance;
      points.push_back(Point_3(7., -5., 3.) + p.x() * e1 + p.y() * e2 + height * across);
      // given normals need not be accurate
      const Vector_3 tilt = .2 * (gauss(random) * e1 + gauss(random) * e2);
      sides.push_back(unit((has_opposite_sides && layer == 0 ? -across : across) + tilt));
      scans.push_back(layer);
    }
    neighbors.resize(n - 1);
    std::iota(neighbors.begin(), neighbors.end(), std::uint32_t(1));
  }

  static Vector_3 unit(const Vector_3& v) { return v / std::sqrt(v.squared_length()); }

  internal::Side_evidence side_evidence() const
  {
    return internal::side_evidence(points, 0, neighbors.data(), neighbors.size(), sides);
  }
  double scan_evidence() const
  {
    return internal::scan_evidence(points, 0, neighbors.data(), neighbors.size(), scans).share;
  }
};

double mean_of(int draws, const std::function<double()>& draw)
{
  double sum = 0.;
  for (int i = 0; i < draws; ++i)
    sum += draw();
  return sum / draws;
}

} // namespace

BOOST_AUTO_TEST_CASE(sides_that_agree_are_not_mixed)
{
  std::mt19937 random(1);
  for (const double distance : {0., 2. * sigma, 4. * sigma}) {
    Patch patch(40, distance, random);
    const internal::Side_evidence evidence = patch.side_evidence();
    BOOST_TEST(evidence.mixture == 0.);
    BOOST_TEST(evidence.known == 40u);
    BOOST_TEST(evidence.t == 0.);
    // those that are not known do not count
    std::fill_n(patch.sides.begin(), 10, Vector_3(0., 0., 0.));
    BOOST_TEST(patch.side_evidence().known == 30u);
    BOOST_TEST(patch.side_evidence().mixture == 0.);
  }
}

BOOST_AUTO_TEST_CASE(random_sides_are_no_evidence)
{
  for (const std::size_t n : {13u, 25u, 49u, 97u}) {
    std::mt19937 random(2);
    double sum = 0.;
    const double mean_square = mean_of(1000, [&] {
      Patch patch(n, 0., random);
      for (Vector_3& side : patch.sides)
        if (random() % 2)
          side = -side;
      const internal::Side_evidence evidence = patch.side_evidence();
      sum += evidence.t;
      return evidence.t * evidence.t;
    });
    BOOST_TEST(mean_square > .7);
    BOOST_TEST(mean_square < 1.4);
    BOOST_TEST(std::abs(sum / 1000.) < .15);
  }
}

BOOST_AUTO_TEST_CASE(the_sheets_of_a_wall_lie_apart)
{
  for (const double separation : {2., 4.}) {
    std::mt19937 random(3);
    double least = 1e300;
    const double mean = mean_of(200, [&] {
      Patch patch(49, separation * sigma, random, true);
      const internal::Side_evidence evidence = patch.side_evidence();
      BOOST_REQUIRE(evidence.mixture > 0.);
      BOOST_REQUIRE(evidence.known == 49u);
      least = (std::min)(least, evidence.t);

      // normals into the wall: the same evidence with the other sign
      for (Vector_3& side : patch.sides)
        side = -side;
      BOOST_REQUIRE(patch.side_evidence().t == -evidence.t);
      return evidence.t;
    });
    // two samples of half of the points
    BOOST_TEST(mean == separation / std::sqrt(4. / 49.), boost::test_tools::tolerance(.12));
    BOOST_TEST(least > 3.);
  }
}

BOOST_AUTO_TEST_CASE(little_is_no_evidence_for_sides)
{
  std::mt19937 random(4);
  Patch patch(3, sigma, random);
  patch.sides = {Vector_3(0., 0., 0.), patch.sides[1], -patch.sides[1]};
  patch.neighbors = {1, 2};
  BOOST_TEST(patch.side_evidence().known <= 2u); // a plane through three points may be anywhere
  BOOST_TEST(patch.side_evidence().t == 0.);
  patch.neighbors.clear();
  BOOST_TEST(patch.side_evidence().known == 0u);

  // without noise
  const internal::Array<Point_3> flat = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  const internal::Array<Vector_3> up_and_down = {{0, 0, 1}, {0, 0, -1}, {0, 0, 1}, {0, 0, -1}};
  const std::uint32_t others[] = {1, 2, 3};
  BOOST_TEST(internal::side_evidence(flat, 0, others, 3, up_and_down).t == 0.);
}

BOOST_AUTO_TEST_CASE(scans_explain_the_distance_between_their_layers)
{
  for (const double separation : {0., 1., 2., 4., 8.}) {
    std::mt19937 random(5);
    const double share =
        mean_of(300, [&] { return Patch(49, separation * sigma, random).scan_evidence(); });
    const double a = separation / 2., expected = a * a / (a * a + 1.);
    BOOST_TEST(std::abs(share - expected) < .03);
  }
}

BOOST_AUTO_TEST_CASE(the_variance_between_scans_has_no_bias)
{
  for (const double separation : {0., 1., 4.}) {
    std::mt19937 random(7);
    const double variance = mean_of(1000, [&] {
      const Patch patch(49, separation * sigma, random);
      return internal::scan_evidence(patch.points, 0, patch.neighbors.data(),
                                     patch.neighbors.size(), patch.scans)
          .variance;
    });
    const double a = separation * sigma / 2.;
    BOOST_TEST(std::abs(variance - a * a) < .03 * (a * a + sigma * sigma));
  }
}

BOOST_AUTO_TEST_CASE(the_number_of_scans_and_their_numbers_do_not_matter)
{
  std::mt19937 random(6);
  Patch patch(49, 4. * sigma, random);
  const double share = patch.scan_evidence();
  for (std::uint32_t& scan : patch.scans)
    scan = scan == 0 ? 4000000000u : 17u;
  BOOST_TEST(patch.scan_evidence() == share, boost::test_tools::tolerance(1e-12));

  const double of_many = mean_of(300, [&] {
    Patch flat(97, 0., random);
    for (std::uint32_t& scan : flat.scans)
      scan = std::uint32_t(random() % 15);
    return flat.scan_evidence();
  });
  BOOST_TEST(of_many < .05);

  // each scan has seen another part
  const double of_parts = mean_of(300, [&] {
    Patch flat(97, 0., random);
    for (std::size_t i = 0; i < flat.points.size(); ++i)
      flat.scans[i] = flat.points[i].x() < flat.points[0].x();
    return flat.scan_evidence();
  });
  BOOST_TEST(of_parts < .05);

  std::fill(patch.scans.begin(), patch.scans.end(), 3u); // one scan
  BOOST_TEST(patch.scan_evidence() == 0.);
  std::iota(patch.scans.begin(), patch.scans.end(), 0u); // one for each point
  BOOST_TEST(patch.scan_evidence() == 0.);
}

namespace {

/// Geary's C of what a quadric leaves of heights over random places
double gearys_c(std::mt19937& random, double noise,
                const std::function<double(double, double)>& shape)
{
  std::normal_distribution<double> gauss(0., 1.);
  std::uniform_real_distribution<double> place(-1., 1.);
  internal::Array<Point_3> points;
  std::vector<std::uint32_t> members(25);
  std::iota(members.begin(), members.end(), 0u);
  while (points.size() < members.size()) {
    const double x = points.empty() ? 0. : place(random), y = points.empty() ? 0. : place(random);
    if (x * x + y * y <= 1.)
      points.push_back(Point_3(x, y, .1 * shape(x, y) + noise * gauss(random)));
  }
  return internal::Quadric_fit(points, members, 1.).gearys_c();
}

} // namespace

BOOST_AUTO_TEST_CASE(gearys_c_tells_noise_from_shape)
{
  std::mt19937 random(8);
  const auto plane = [](double, double) { return 0.; };
  const auto cubic = [](double x, double y) { return x * x * x - y * x * y; };
  const auto wave = [](double x, double y) { return std::sin(3. * x + y); };
  const auto mean_over = [&](double noise, const std::function<double(double, double)>& shape) {
    return mean_of(400, [&] { return gearys_c(random, noise, shape); });
  };
  BOOST_TEST(std::abs(mean_over(.05, plane) - 1.27) < .05);
  BOOST_TEST(mean_over(0., cubic) < .9);
  BOOST_TEST(mean_over(0., wave) < .9);
  double before = mean_over(0., wave);
  for (const double noise : {.02, .04, .08}) {
    const double both = mean_over(noise, wave);
    BOOST_TEST(both > before + .05);
    before = both;
  }
  BOOST_TEST(gearys_c(random, 0., plane) < 1.5); // no residual but rounding, which tells nothing
}

BOOST_AUTO_TEST_CASE(duplicates_have_one_side_and_one_scan)
{
  const internal::Array<Point_3> points = {{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {2, 0, 0},
                                           {1, 0, 0}, {3, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  const Vector_3 up(0, 0, 1), down(0, 0, -1), slant(.6, 0, .8), none(0, 0, 0);
  const internal::Array<Vector_3> sides = {up, slant, none, up, up, none, slant, down};
  const internal::Array<std::uint32_t> scans = {5, 9, 2, 7, 8, 1, 8, 7};
  internal::Loops<CGAL::Sequential_tag> loops(nullptr, 1.);
  const auto merged = [&](double sign) {
    internal::Array<Vector_3> given;
    for (const Vector_3& side : sides)
      given.push_back(sign * side);
    internal::Point_buffer buffer(points, {}, {}, {}, loops);
    buffer.add_layers(given, scans);
    return buffer;
  };
  const internal::Point_buffer buffer = merged(1.), turned = merged(-1.);
  const auto at = [&](std::size_t i) { return buffer.sides[buffer.site_of[i]]; };
  BOOST_TEST(buffer.sides.size() == 4u);
  BOOST_TEST((at(0) == up));                   // the other one is not known
  BOOST_TEST((at(1) == up || at(1) == slant)); // they agree
  BOOST_TEST((at(3) == none));                 // they do not
  BOOST_TEST((at(5) == none));
  for (std::size_t i = 0; i < buffer.size(); ++i)
    BOOST_TEST((turned.sides[i] == -buffer.sides[i]));
  BOOST_TEST(buffer.scans[buffer.site_of[0]] == 2u);
  BOOST_TEST(buffer.scans[buffer.site_of[1]] == 8u);
  BOOST_TEST(buffer.scans[buffer.site_of[3]] == 7u);
  BOOST_TEST(buffer.scans[buffer.site_of[5]] == 1u);

  internal::Point_buffer without(points, {}, {}, {}, loops);
  without.add_layers({}, {});
  BOOST_TEST(without.sides.empty());
  BOOST_TEST(without.scans.empty());
}
