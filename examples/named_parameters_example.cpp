// SPDX-License-Identifier: GPL-3.0-or-later
// Points in pairs, in tuples and in a Point_set_3, and parameters by name.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/balanced_flow_smooth_point_set.h>
#include <CGAL/point_generators_3.h>

#include <iostream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point_3;
typedef Kernel::Vector_3 Vector_3;
typedef CGAL::Parallel_if_available_tag Concurrency_tag;

int main()
{
  std::vector<Point_3> sphere;
  std::copy_n(CGAL::Random_points_on_sphere_3<Point_3>(1.), 5000, std::back_inserter(sphere));
  CGAL::Random random(1);
  for (Point_3& p : sphere)
    p = p + Vector_3(random.get_double(-.02, .02), random.get_double(-.02, .02),
                     random.get_double(-.02, .02));

  // pairs of point and normal: the normals are computed and written, too
  typedef std::pair<Point_3, Vector_3> Point_with_normal;
  std::vector<Point_with_normal> pairs;
  for (const Point_3& p : sphere)
    pairs.emplace_back(p, CGAL::NULL_VECTOR);
  CGAL::balanced_flow_smooth_point_set<Concurrency_tag>(
      pairs, 24,
      CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Point_with_normal>())
          .normal_map(CGAL::Second_of_pair_property_map<Point_with_normal>()));
  std::cout << "first normal: " << pairs.front().second << std::endl;

  // tuples, and a callback; this package's own parameters come first
  typedef std::tuple<Point_3, unsigned char, std::string> Labeled_point;
  std::vector<Labeled_point> tuples;
  for (const Point_3& p : sphere)
    tuples.emplace_back(p, 7, "sphere");
  const double moved = CGAL::balanced_flow_smooth_point_set<Concurrency_tag>(
      tuples, CGAL::parameters::step_length(.5)
                  .update_period(6)
                  .number_of_iterations(18)
                  .sharpness_angle(20.)
                  .point_map(CGAL::Nth_of_tuple_property_map<0, Labeled_point>())
                  .callback([](double share) { return share <= 1.; })); // false would cancel
  std::cout << "mean movement of the last iteration: " << moved << std::endl;

  // a Point_set_3 needs no maps
  CGAL::Point_set_3<Point_3> point_set;
  for (const Point_3& p : sphere)
    point_set.insert(p);
  CGAL::balanced_flow_smooth_point_set<Concurrency_tag>(point_set, 24);
  std::cout << "first point: " << sphere.front() << " -> " << point_set.point(*point_set.begin())
            << std::endl;
}
