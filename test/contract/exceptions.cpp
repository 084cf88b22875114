// SPDX-License-Identifier: GPL-3.0-or-later
// What is thrown, for bad arguments, failing maps and flows that diverge, and that nothing is changed
// then.
#define BOOST_TEST_MODULE exceptions
#include <boost/test/unit_test.hpp>

#include "shapes.h"

#include <CGAL/Point_set_flow/analyze_point_set.h>
#include <CGAL/Point_set_flow/estimate_point_set_scale.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/balanced_flow_smooth_point_set.h>
#include <CGAL/estimate_point_set_noise.h>

#include <numeric>
#include <sstream>

namespace np = CGAL::parameters;
using namespace CGAL::Point_set_flow;
using shapes::noisy_cube;
using shapes::Points;
typedef CGAL::Sequential_tag Sequential;

namespace {

/// The message is compared as a whole: which function, which argument, which value, why not
template <typename Call>
void check_message(const std::string& expected, const Call& call)
{
  BOOST_CHECK_EXCEPTION(call(), std::invalid_argument, [&](const std::invalid_argument& e) {
    BOOST_TEST(std::string(e.what()) == expected);
    return true;
  });
}

const std::string smooth_function = "CGAL::balanced_flow_smooth_point_set: ";
const double not_a_number = std::numeric_limits<double>::quiet_NaN(),
             infinity = std::numeric_limits<double>::infinity();

} // namespace

BOOST_AUTO_TEST_CASE(errors_name_the_argument_and_leave_the_points_unchanged)
{
  const Points noisy = noisy_cube(6);
  const auto check = [&](const std::string& expected, const auto& call) {
    Points points = noisy;
    check_message(smooth_function + expected, [&] { call(points); });
    BOOST_TEST((points == noisy));
  };
  const auto with = [&](const auto& pack) {
    return
        [&](Points& points) { CGAL::balanced_flow_smooth_point_set<Sequential>(points, 20, pack); };
  };
  const auto with_k = [](unsigned int k) {
    return [k](Points& points) { CGAL::balanced_flow_smooth_point_set<Sequential>(points, k); };
  };
  check("k is 0, but at least 2 neighbors are needed", with_k(0));
  check("k is 1, but at least 2 neighbors are needed", with_k(1));
  check("k is 4294967295, but must be a number from 2 to 2147483647", with_k(unsigned(-1)));

  const std::string not_negative = ", but must be finite and not negative";
  check("step_length is -1" + not_negative, with(np::step_length(-1.)));
  check("step_length is nan" + not_negative, with(np::step_length(not_a_number)));
  check("step_length is inf" + not_negative, with(np::step_length(infinity)));
  check("filter_width is -2" + not_negative, with(np::filter_width(-2)));
  check("feature_threshold is inf" + not_negative, with(np::feature_threshold(infinity)));
  check("noise is -1" + not_negative, with(np::noise(-1.)));
  check("noise is nan" + not_negative, with(np::noise(not_a_number)));
  check("noise is inf" + not_negative, with(np::noise(infinity)));
  check("neighbor_radius is -1" + not_negative, with(np::neighbor_radius(-1.)));
  check("neighbor_radius is inf" + not_negative, with(np::neighbor_radius(infinity)));

  const std::string degrees = ", but must be in (0, 180] degrees";
  check("sharpness_angle is 0" + degrees, with(np::sharpness_angle(0.)));
  check("sharpness_angle is nan" + degrees, with(np::sharpness_angle(not_a_number)));
  check("sharpness_angle is 181" + degrees, with(np::sharpness_angle(181)));

  const std::string whole = ", but must be a whole number from 0 to 2147483647";
  check("number_of_iterations is -3" + whole, with(np::number_of_iterations(-3)));
  check("number_of_iterations is 1.5" + whole, with(np::number_of_iterations(1.5)));
  check("number_of_iterations is nan" + whole, with(np::number_of_iterations(not_a_number)));
  check("update_period is -1" + whole, with(np::update_period(-1)));
  check("number_of_relaxation_steps is -1" + whole, with(np::number_of_relaxation_steps(-1)));
  check("block_size is 4294967296" + whole, with(np::block_size(std::size_t(1) << 32)));
  check("block_size is 0, but must be positive", with(np::block_size(0)));
}

BOOST_AUTO_TEST_CASE(coordinates_that_are_not_finite_are_named)
{
  const std::string reason = ", but coordinates must be finite";
  const Points noisy = noisy_cube(6);
  Points bad = noisy;
  bad[17] = shapes::Point_3(1, not_a_number, 2);
  check_message(smooth_function + "points[17] is (1, nan, 2)" + reason,
                [&] { CGAL::balanced_flow_smooth_point_set<Sequential>(bad); });
  BOOST_TEST((bad[16] == noisy[16]));

  typedef std::pair<shapes::Point_3, shapes::Point_3> Pair;
  std::vector<Pair> pairs;
  for (const auto& p : noisy)
    pairs.emplace_back(p, p);
  pairs[5].second = shapes::Point_3(infinity, 0, 0);
  check_message(smooth_function + "initial_point_map[5] is (inf, 0, 0)" + reason, [&] {
    CGAL::balanced_flow_smooth_point_set<Sequential>(
        pairs, np::initial_point_map(CGAL::Second_of_pair_property_map<Pair>())
                   .point_map(CGAL::First_of_pair_property_map<Pair>()));
  });
  BOOST_TEST((pairs[4].first == noisy[4]));
}

BOOST_AUTO_TEST_CASE(noise_that_is_none_is_named)
{
  typedef std::pair<shapes::Point_3, float> Pair;
  for (const double bad : {not_a_number, infinity, -2.}) {
    std::vector<Pair> pairs;
    for (const auto& p : noisy_cube(6))
      pairs.emplace_back(p, .1f);
    pairs[17].second = float(bad);
    const std::vector<Pair> before = pairs;
    std::ostringstream value;
    value << bad;
    check_message(smooth_function + "noise[17] is " + value.str() +
                      ", but must be finite and not negative",
                  [&] {
                    CGAL::balanced_flow_smooth_point_set<Sequential>(
                        pairs, np::noise(CGAL::Second_of_pair_property_map<Pair>())
                                   .point_map(CGAL::First_of_pair_property_map<Pair>()));
                  });
    for (std::size_t i = 0; i < pairs.size(); ++i)
      BOOST_REQUIRE((pairs[i].first == before[i].first));
  }
}

BOOST_AUTO_TEST_CASE(errors_name_the_function_that_was_called)
{
  Points bad = noisy_cube(6);
  bad[3] = shapes::Point_3(not_a_number, 0, 0);
  const std::string expected = "points[3] is (nan, 0, 0), but coordinates must be finite";
  check_message("CGAL::balanced_flow_smooth_point_set: " + expected,
                [&] { CGAL::balanced_flow_smooth_point_set<Sequential>(bad, 20); });
  check_message("CGAL::estimate_point_set_noise: " + expected,
                [&] { CGAL::estimate_point_set_noise<Sequential>(bad); });
  check_message("CGAL::Point_set_flow::estimate_point_set_scale: " + expected,
                [&] { estimate_point_set_scale<Sequential>(bad); });
  check_message("CGAL::Point_set_flow::analyze_point_set: " + expected,
                [&] { analyze_point_set<Sequential>(bad, np::step_length(.5)); });
  check_message(
      "CGAL::Point_set_flow::analyze_point_set: k is 1, but at least 2 neighbors are needed",
      [&] { analyze_point_set<Sequential>(bad, 1); });
}

// ---- maps that are too small

BOOST_AUTO_TEST_CASE(maps_of_another_point_set_are_refused)
{
  typedef CGAL::Point_set_3<shapes::Point_3> Point_set;
  Point_set points(true), fewer(true);
  for (const auto& p : noisy_cube(6))
    points.insert(p);
  for (int i = 0; i < 100; ++i)
    fewer.insert(shapes::Point_3(0, 0, 0));
  const Point_set before = points;
  const auto check = [&](const std::string& expected, const auto& parameters) {
    check_message(smooth_function + expected,
                  [&] { CGAL::balanced_flow_smooth_point_set<Sequential>(points, parameters); });
    for (const auto& i : points)
      BOOST_REQUIRE((points.point(i) == before.point(i) && points.normal(i) == before.normal(i)));
  };
  const auto size_of = [](const std::string& map) {
    return "the size of " + map + " is 100, but points[100] has the number 100";
  };
  check(size_of("point_map"), np::point_map(fewer.point_map()));
  check(size_of("normal_map"), np::normal_map(fewer.normal_map()));
  check(size_of("initial_point_map"), np::initial_point_map(fewer.point_map()));
  check(size_of("feature_strength_map"),
        np::feature_strength_map(fewer.add_property_map<double>("strength", 0.).first));
  check(size_of("point_is_constrained_map"),
        np::point_is_constrained_map(fewer.add_property_map<bool>("fixed", false).first));
  check(size_of("noise"), np::noise(fewer.add_property_map<double>("noise", 0.).first));
  check("noise is null, but must be the map of a property",
        np::noise(Point_set::Property_map<double>()));
  check("feature_strength_map is null, but must be the map of a property",
        np::feature_strength_map(Point_set::Property_map<double>()));
}

// ---- maps that throw

namespace {

/// Counts how often maps are read and written, and throws when told to
struct Access {
  long reads_left = -1, writes_left = -1; // negative: as many as wanted
  bool throws_for_ever = false, writes_before_it_throws = false;

  void count(long& left) const
  {
    if (left < 0)
      return;
    if (left == 0) {
      if (!throws_for_ever)
        left = -1;
      throw std::out_of_range("no such value");
    }
    --left;
  }
};

/// A map from indices to a vector whose values come in proxies
template <typename Value>
struct Throwing_map {
  typedef std::size_t key_type;
  typedef Value value_type;
  struct reference {
    const Value* value;
    operator const Value&() const { return *value; }
  };
  typedef boost::read_write_property_map_tag category;
  std::vector<Value>* values;
  Access* access;

  friend reference get(const Throwing_map& map, key_type i)
  {
    map.access->count(map.access->reads_left);
    return {&map.values->at(i)};
  }
  friend void put(const Throwing_map& map, key_type i, const Value& value)
  {
    if (map.access->writes_before_it_throws)
      map.values->at(i) = value;
    map.access->count(map.access->writes_left);
    map.values->at(i) = value;
  }
};

struct Cloud {
  Points points = noisy_cube(4, .05);
  std::vector<shapes::Vector_3> normals;
  std::vector<double> strengths;
  std::vector<char> fixed;
  std::vector<double> noises;

  Cloud()
      : normals(points.size(), shapes::Vector_3(0, 0, 2)), strengths(points.size(), -1.),
        fixed(points.size(), 0), noises(points.size(), .05)
  {}
  bool operator==(const Cloud& other) const
  {
    return points == other.points && normals == other.normals && strengths == other.strengths;
  }
};

double smooth(Cloud& cloud, Access& access)
{
  std::vector<std::size_t> indices(cloud.points.size());
  std::iota(indices.begin(), indices.end(), std::size_t(0));
  return CGAL::balanced_flow_smooth_point_set<Sequential>(
      indices, 10,
      np::feature_strength_map(Throwing_map<double>{&cloud.strengths, &access})
          .noise(Throwing_map<double>{&cloud.noises, &access})
          .number_of_iterations(1)
          .point_map(Throwing_map<shapes::Point_3>{&cloud.points, &access})
          .normal_map(Throwing_map<shapes::Vector_3>{&cloud.normals, &access})
          .point_is_constrained_map(Throwing_map<char>{&cloud.fixed, &access}));
}

} // namespace

BOOST_AUTO_TEST_CASE(wherever_a_map_throws_all_values_are_as_before)
{
  const Cloud noisy;
  for (const bool option : {false, true})
    for (long Access::*left : {&Access::reads_left, &Access::writes_left}) {
      const bool writes = left == &Access::writes_left;
      long n = 0;
      for (bool has_thrown = true; has_thrown; ++n) {
        Cloud cloud = noisy;
        Access access;
        if (writes) // what can never be written again cannot be taken back
          access.writes_before_it_throws = option;
        else
          access.throws_for_ever = option;
        access.*left = n;
        has_thrown = false;
        try {
          smooth(cloud, access);
        }
        catch (const std::out_of_range&) {
          has_thrown = true;
        }
        BOOST_REQUIRE((cloud == noisy) == has_thrown);
      }
      BOOST_TEST_MESSAGE((writes ? "writes: " : "reads: ") << n - 1);
      BOOST_TEST(n - 1 >= 3 * long(noisy.points.size())); // points, normals, strengths
    }
}

BOOST_AUTO_TEST_CASE(a_map_that_cannot_be_written_any_more_ends_in_an_exception_not_in_termination)
{
  Cloud cloud;
  Access access;
  access.throws_for_ever = true;
  access.writes_left = 100;
  BOOST_CHECK_THROW(smooth(cloud, access), std::out_of_range);
}

BOOST_AUTO_TEST_CASE(the_exception_of_a_map_that_checks_its_keys_is_passed_on)
{
  Cloud cloud, before;
  cloud.normals.pop_back(); // one too few: vector::at() throws
  before.normals.pop_back();
  Access access;
  BOOST_CHECK_THROW(smooth(cloud, access), std::out_of_range);
  BOOST_TEST((cloud == before));
}

BOOST_AUTO_TEST_CASE(exceptions_of_the_callback_leave_the_points_unchanged)
{
  const Points noisy = noisy_cube(6);
  for (const double when : {0., .1, .3, .5, .9, 1.}) {
    const auto throwing = [when](double share) -> bool {
      if (share >= when)
        throw std::runtime_error("from the callback");
      return true;
    };
    Points points = noisy;
    BOOST_CHECK_THROW(CGAL::balanced_flow_smooth_point_set<CGAL::Parallel_if_available_tag>(
                          points, np::callback(std::function<bool(double)>(throwing))),
                      std::runtime_error);
    BOOST_TEST((points == noisy));
  }
}

// ---- flows that diverge

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
