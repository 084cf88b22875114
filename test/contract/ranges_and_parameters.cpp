// SPDX-License-Identifier: GPL-3.0-or-later
// Drop-in use of balanced_flow_smooth_point_set(): ranges, kernels, maps, named parameters, what is
// returned.
#define BOOST_TEST_MODULE ranges_and_parameters
#include <boost/test/unit_test.hpp>

#include "smoothed.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Point_set_3.h>

#include <deque>
#include <list>
#include <numeric>
#include <tuple>

namespace np = CGAL::parameters;
using namespace CGAL::Point_set_flow;
using shapes::largest_difference;
using shapes::noisy_cube;
using shapes::Points;
using shapes::smoothed;
typedef CGAL::Sequential_tag Sequential;

namespace {

/// The points of a range, read through a map
template <typename Range, typename Map>
Points points_of(const Range& range, Map map)
{
  Points points;
  for (const auto& key : range) {
    const auto& p = get(map, key);
    points.emplace_back(p.x(), p.y(), p.z());
  }
  return points;
}

template <typename Pack, typename = void>
struct Takes_step_length : std::false_type {};
template <typename Pack>
struct Takes_step_length<Pack, std::void_t<decltype(std::declval<Pack>().step_length(.5))>>
    : std::true_type {};

} // namespace

// ---- drop-in use: whatever the range, the result is that of a vector of points

BOOST_AUTO_TEST_CASE(any_range_and_kernel_give_the_same_points)
{
  const Points noisy = noisy_cube(), expected = smoothed(noisy);
  BOOST_TEST(largest_difference(noisy, expected) > .01);

  std::deque<shapes::Point_3> deque(noisy.begin(), noisy.end());
  CGAL::balanced_flow_smooth_point_set<Sequential>(deque, 20);
  BOOST_TEST((Points(deque.begin(), deque.end()) == expected));

  std::list<shapes::Point_3> list(noisy.begin(), noisy.end());
  CGAL::balanced_flow_smooth_point_set<Sequential>(list, 20);
  BOOST_TEST((Points(list.begin(), list.end()) == expected));

  typedef CGAL::Exact_predicates_inexact_constructions_kernel Epick;
  std::vector<Epick::Point_3> epick;
  for (const auto& p : noisy)
    epick.emplace_back(p.x(), p.y(), p.z());
  CGAL::balanced_flow_smooth_point_set<CGAL::Parallel_if_available_tag>(epick, 20);
  BOOST_TEST((points_of(epick, CGAL::Identity_property_map<Epick::Point_3>()) == expected));

  typedef CGAL::Simple_cartesian<float> Float_kernel;
  std::vector<Float_kernel::Point_3> floats;
  for (const auto& p : noisy)
    floats.emplace_back(float(p.x()), float(p.y()), float(p.z()));
  CGAL::balanced_flow_smooth_point_set<Sequential>(floats, 20);
  BOOST_TEST(
      largest_difference(points_of(floats, CGAL::Identity_property_map<Float_kernel::Point_3>()),
                         expected) < 1e-5);
}

namespace {
/// Points and vectors with nothing but what the documentation asks for
struct Minimal_kernel {
  typedef float FT;
  template <typename>
  struct Ambient_dimension { // CGAL 6.2 asks for it, and for R
    typedef CGAL::Dimension_tag<3> type;
  };
  class Triple {
    float m_x, m_y, m_z;

  public:
    typedef Minimal_kernel R;
    Triple(float x, float y, float z) : m_x(x), m_y(y), m_z(z) {}
    float x() const { return m_x; }
    float y() const { return m_y; }
    float z() const { return m_z; }
  };
  struct Point_3 : Triple {
    using Triple::Triple;
  };
  struct Vector_3 : Triple {
    using Triple::Triple;
  };
};

typedef std::pair<Minimal_kernel::Point_3, Minimal_kernel::Vector_3> Minimal_pair;
} // namespace

BOOST_AUTO_TEST_CASE(a_minimal_kernel_is_enough)
{
  const Points noisy = noisy_cube();
  Points expected;
  std::vector<Minimal_pair> pairs;
  for (const auto& p : noisy) {
    pairs.emplace_back(Minimal_kernel::Point_3(float(p.x()), float(p.y()), float(p.z())),
                       Minimal_kernel::Vector_3(0, 0, 0));
    expected.emplace_back(float(p.x()), float(p.y()), float(p.z()));
  }
  CGAL::balanced_flow_smooth_point_set<Sequential>(expected, 20);
  CGAL::balanced_flow_smooth_point_set<Sequential>(
      pairs, 20,
      np::point_map(CGAL::First_of_pair_property_map<Minimal_pair>())
          .normal_map(CGAL::Second_of_pair_property_map<Minimal_pair>())
          .geom_traits(Minimal_kernel()));
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const Minimal_kernel::Point_3& p = pairs[i].first;
    BOOST_REQUIRE(CGAL::squared_distance(shapes::Point_3(p.x(), p.y(), p.z()), expected[i]) <
                  1e-12);
  }
}

BOOST_AUTO_TEST_CASE(pairs_tuples_and_indices_give_the_same_points)
{
  const Points noisy = noisy_cube(), expected = smoothed(noisy);

  typedef std::pair<shapes::Point_3, shapes::Vector_3> Pair;
  std::vector<Pair> pairs;
  for (const auto& p : noisy)
    pairs.emplace_back(p, CGAL::NULL_VECTOR);
  CGAL::First_of_pair_property_map<Pair> first;
  CGAL::Second_of_pair_property_map<Pair> second;
  CGAL::balanced_flow_smooth_point_set<Sequential>(pairs, 20,
                                                   np::point_map(first).normal_map(second));
  BOOST_TEST((points_of(pairs, first) == expected));
  for (const Pair& pair : pairs)
    BOOST_REQUIRE(std::abs(pair.second.squared_length() - 1.) < 1e-12);

  typedef std::tuple<int, shapes::Point_3, std::string> Tuple;
  std::vector<Tuple> tuples;
  for (const auto& p : noisy)
    tuples.emplace_back(int(tuples.size()), p, "label");
  CGAL::Nth_of_tuple_property_map<1, Tuple> nth;
  CGAL::balanced_flow_smooth_point_set<Sequential>(tuples, 20, np::point_map(nth));
  BOOST_TEST((points_of(tuples, nth) == expected));
  BOOST_TEST(std::get<0>(tuples[7]) == 7);

  // a range of indices: only every second point takes part
  Points coordinates = noisy, half;
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < noisy.size(); i += 2) {
    indices.push_back(i);
    half.push_back(noisy[i]);
  }
  CGAL::balanced_flow_smooth_point_set<Sequential>(
      indices, 20, np::point_map(CGAL::make_property_map(coordinates)));
  const Points expected_half = smoothed(half);
  for (std::size_t i = 0; i < noisy.size(); ++i)
    BOOST_REQUIRE((coordinates[i] == (i % 2 == 0 ? expected_half[i / 2] : noisy[i])));
}

BOOST_AUTO_TEST_CASE(a_point_set_3_gives_the_same_points_and_gets_no_normal_map)
{
  const Points noisy = noisy_cube(), expected = smoothed(noisy);
  typedef CGAL::Point_set_3<shapes::Point_3> Point_set;
  Point_set bare;
  for (const auto& p : noisy)
    bare.insert(p);
  Point_set with_normals = bare;
  with_normals.add_normal_map();

  for (Point_set copy : {bare, with_normals}) {
    const bool had_normals = copy.has_normal_map();
    CGAL::balanced_flow_smooth_point_set<Sequential>(copy, 20);
    BOOST_TEST((points_of(copy, copy.point_map()) == expected));
    BOOST_TEST(copy.has_normal_map() == had_normals);
  }
  for (Point_set copy : {bare, with_normals}) {
    // parameters() names a normal map even if there is none; none must be added
    const bool had_normals = copy.has_normal_map();
    CGAL::balanced_flow_smooth_point_set<Sequential>(copy, 20, copy.parameters());
    BOOST_TEST((points_of(copy, copy.point_map()) == expected));
    BOOST_TEST(copy.has_normal_map() == had_normals);
    if (had_normals)
      for (const auto& index : copy)
        BOOST_REQUIRE(std::abs(copy.normal(index).squared_length() - 1.) < 1e-12);
  }
  Point_set copy = with_normals;
  CGAL::balanced_flow_smooth_point_set<Sequential>(
      copy, 20, np::update_period(4).point_map(copy.point_map()).normal_map(copy.normal_map()));
  BOOST_TEST((points_of(copy, copy.point_map()) == expected));

  // removed points take no part and stay
  Point_set removed = bare;
  removed.insert(shapes::Point_3(9, 9, 9));
  removed.remove(removed.end() - 1);
  CGAL::balanced_flow_smooth_point_set<Sequential>(removed, 20);
  BOOST_TEST((points_of(removed, removed.point_map()) == expected));
}

// ---- named parameters

BOOST_AUTO_TEST_CASE(named_parameters_combine_in_any_order)
{
  const Points noisy = noisy_cube();
  const auto run = [&](const auto& pack) {
    Points points = noisy;
    CGAL::balanced_flow_smooth_point_set<Sequential>(points, 20, pack);
    return points;
  };
  const CGAL::Identity_property_map<shapes::Point_3> map;
  const Points a =
      run(np::feature_threshold(1000.).step_length(.5).number_of_iterations(8).point_map(map));
  const Points b = run(np::step_length(.5).feature_threshold(1000).number_of_iterations(8));
  const Points c = run(np::flow(Balanced_flow())
                           .update_period(4)
                           .curvature(Learned_curvature())
                           .feature_threshold(1000.f)
                           .step_length(.5)
                           .point_map(map)
                           .number_of_iterations(8));
  BOOST_TEST((a == b));
  BOOST_TEST((a == c));
  BOOST_TEST((a != run(np::number_of_iterations(8))));
  BOOST_TEST((run(np::point_map(map)) == smoothed(noisy)));
  BOOST_TEST((run(np::default_values()) == smoothed(noisy)));
  // the angle chooses K where none is given
  BOOST_TEST((run(np::sharpness_angle(10)) != run(np::sharpness_angle(80))));
  BOOST_TEST((run(np::feature_threshold(1e3).sharpness_angle(10)) ==
              run(np::feature_threshold(1e3).sharpness_angle(80))));
}

// or the parameters of CGAL between would be lost
BOOST_AUTO_TEST_CASE(parameters_of_the_package_are_refused_after_one_of_cgal)
{
  const auto ours = np::feature_threshold(1000.).update_period(4);
  const auto cgals = ours.number_of_iterations(8);
  BOOST_TEST(Takes_step_length<decltype(ours)>::value);
  BOOST_TEST(!Takes_step_length<decltype(cgals)>::value);
}

BOOST_AUTO_TEST_CASE(without_k_the_size_is_chosen_from_the_data)
{
  const Points noisy = noisy_cube();
  Points automatic = noisy, with_pack = noisy, literal = noisy;
  CGAL::balanced_flow_smooth_point_set<Sequential>(automatic);
  CGAL::balanced_flow_smooth_point_set<Sequential>(with_pack, np::step_length(.75));
  CGAL::balanced_flow_smooth_point_set<Sequential>(literal, 7); // an int: a k, not a pack
  BOOST_TEST((automatic == with_pack));
  BOOST_TEST((literal != automatic));

  // the paper's estimator takes one size for all points
  Points paper = noisy;
  CGAL::balanced_flow_smooth_point_set<Sequential>(paper, np::curvature(Covariance_curvature()));
  bool found = false;
  for (unsigned int k = 16; k <= 32 && !found; ++k) {
    Points given = noisy;
    CGAL::balanced_flow_smooth_point_set<Sequential>(given, k,
                                                     np::curvature(Covariance_curvature()));
    found = given == paper;
  }
  BOOST_TEST(found);
}

BOOST_AUTO_TEST_CASE(neighbor_radius_limits_the_nearest_k)
{
  const Points noisy = noisy_cube();
  const auto run = [&](double radius) {
    Points points = noisy;
    CGAL::balanced_flow_smooth_point_set<Sequential>(points, 20, np::neighbor_radius(radius));
    return points;
  };
  BOOST_TEST((run(0.) == smoothed(noisy)));
  BOOST_TEST((run(100.) == smoothed(noisy))); // never reached
  BOOST_TEST((run(.2) != smoothed(noisy)));
  BOOST_TEST((run(1e-6) == noisy)); // nobody has a neighbor

  // a far point must not reach for the others
  Points far = noisy;
  far.emplace_back(50., 50., 50.);
  CGAL::balanced_flow_smooth_point_set<Sequential>(far, 20, np::neighbor_radius(1.));
  BOOST_TEST((far.back() == shapes::Point_3(50., 50., 50.)));
}

// ---- output maps and constraints

BOOST_AUTO_TEST_CASE(normals_are_accurate_and_keep_their_orientation)
{
  typedef std::pair<shapes::Point_3, shapes::Vector_3> Pair;
  Points noisy = shapes::sphere(2000, 3.);
  shapes::add_noise(noisy, .02);
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < noisy.size(); ++i) {
    const shapes::Vector_3 outward = (noisy[i] - CGAL::ORIGIN) * .1; // no unit vector
    pairs.emplace_back(noisy[i], i % 3 == 0 ? outward : i % 3 == 1 ? -outward : CGAL::NULL_VECTOR);
  }
  CGAL::balanced_flow_smooth_point_set<CGAL::Parallel_if_available_tag>(
      pairs, 20,
      np::point_map(CGAL::First_of_pair_property_map<Pair>())
          .normal_map(CGAL::Second_of_pair_property_map<Pair>()));
  double mean_cosine = 0.;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const shapes::Vector_3 radial = pairs[i].first - CGAL::ORIGIN;
    const double cosine = pairs[i].second * radial / std::sqrt(radial.squared_length());
    BOOST_REQUIRE(std::abs(pairs[i].second.squared_length() - 1.) < 1e-12);
    mean_cosine += std::abs(cosine) / double(pairs.size());
    if (i % 3 != 2)
      BOOST_REQUIRE((i % 3 == 0 ? cosine : -cosine) > 0.);
  }
  BOOST_TEST(mean_cosine > .99);
}

BOOST_AUTO_TEST_CASE(the_feature_strength_distinguishes_edges_from_faces)
{
  typedef std::pair<shapes::Point_3, float> Pair;
  std::vector<Pair> pairs;
  for (const auto& p : noisy_cube(40, .01))
    pairs.emplace_back(p, -1.f);
  CGAL::balanced_flow_smooth_point_set<Sequential>(
      pairs, np::feature_strength_map(CGAL::Second_of_pair_property_map<Pair>())
                 .point_map(CGAL::First_of_pair_property_map<Pair>()));
  double on_edges = 0., on_faces = 0.;
  int edges = 0, faces = 0;
  for (const Pair& pair : pairs) {
    BOOST_REQUIRE((pair.second >= 0.f && pair.second <= 1.f));
    double c[3] = {std::abs(pair.first.x()), std::abs(pair.first.y()), std::abs(pair.first.z())};
    std::sort(c, c + 3);
    if (c[1] > .97)
      on_edges += pair.second, ++edges;
    else if (c[1] < .6)
      on_faces += pair.second, ++faces;
  }
  BOOST_TEST(on_edges / edges > .4);
  BOOST_TEST(on_faces / faces < .02);
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

// ---- what is returned

BOOST_AUTO_TEST_CASE(the_mean_movement_of_the_last_step_is_returned_in_the_unit_of_the_data)
{
  // this estimator does the same in all steps, however many there are
  const Points noisy = shapes::noisy_cube();
  Points before = noisy, after = noisy;
  CGAL::balanced_flow_smooth_point_set<CGAL::Sequential_tag>(
      before, 20, np::curvature(Covariance_curvature()).number_of_iterations(4));
  const double moved = CGAL::balanced_flow_smooth_point_set<CGAL::Sequential_tag>(
      after, 20, np::curvature(Covariance_curvature()).number_of_iterations(5));
  double mean = 0.;
  for (std::size_t i = 0; i < noisy.size(); ++i)
    mean += std::sqrt(CGAL::squared_distance(before[i], after[i])) / double(noisy.size());
  BOOST_TEST(moved == mean, boost::test_tools::tolerance(1e-9));

  Points none = noisy;
  BOOST_TEST(CGAL::balanced_flow_smooth_point_set<CGAL::Sequential_tag>(
                 none, 20, np::number_of_iterations(0)) == 0.);
  BOOST_TEST((none == noisy));
}
