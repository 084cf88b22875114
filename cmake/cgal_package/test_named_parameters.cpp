// SPDX-License-Identifier: GPL-3.0-or-later
// The package's named parameters are in CGAL's list: they mix with the others in any order.
#include <CGAL/Simple_cartesian.h>
#include <CGAL/balanced_flow_smooth_point_set.h>
#include <CGAL/point_generators_3.h>

#include <cassert>
#include <functional>
#include <iostream>
#include <vector>

typedef CGAL::Simple_cartesian<double>::Point_3 Point_3;
typedef std::vector<Point_3> Points;
namespace np = CGAL::parameters;
using namespace CGAL::Point_set_flow;

Points noisy_sphere()
{
  CGAL::Random random(1);
  Points points;
  std::copy_n(CGAL::Random_points_on_sphere_3<Point_3>(1., random), 2000,
              std::back_inserter(points));
  for (Point_3& p : points)
    p = CGAL::ORIGIN + (1. + random.get_double(-.02, .02)) * (p - CGAL::ORIGIN);
  return points;
}

template <typename NamedParameters>
Points smoothed(const NamedParameters& parameters)
{
  Points points = noisy_sphere();
  CGAL::balanced_flow_smooth_point_set<CGAL::Sequential_tag>(points, 20, parameters);
  return points;
}

int main()
{
  const CGAL::Identity_property_map<Point_3> map;
  const Points own_first = smoothed(np::flow(Volume_preserving_flow())
                                        .curvature(Covariance_curvature())
                                        .step_length(.5)
                                        .sharpness_angle(20.)
                                        .number_of_iterations(3)
                                        .point_map(map));
  const Points mixed = smoothed(np::point_map(map)
                                    .step_length(.5)
                                    .number_of_iterations(3)
                                    .curvature(Covariance_curvature())
                                    .sharpness_angle(20.)
                                    .flow(Volume_preserving_flow()));
  assert(own_first == mixed);
  assert(mixed != smoothed(np::point_map(map)));
  assert(mixed != smoothed(np::number_of_iterations(3).step_length(.25).sharpness_angle(20.)));

  Points points = noisy_sphere();
  std::vector<double> strength(points.size());
  const std::vector<int> scans(points.size(), 1);
  CGAL::Point_set_flow::Smoothing_report report;
  std::vector<std::size_t> indices(points.size());
  for (std::size_t i = 0; i < indices.size(); ++i)
    indices[i] = i;
  CGAL::balanced_flow_smooth_point_set<CGAL::Sequential_tag>(
      indices, np::point_map(CGAL::make_property_map(points))
                   .feature_strength_map(CGAL::make_property_map(strength))
                   .feature_threshold(100.)
                   .filter_width(.5)
                   .update_period(2)
                   .block_size(500)
                   .noise(.02)
                   .scan_map(CGAL::make_property_map(scans))
                   .smoothing_report(std::ref(report))
                   .initial_point_map(CGAL::make_property_map(points)));
  double sum = 0.;
  for (const double s : strength)
    sum += s;
  assert(sum > 0.);
  assert(report.number_of_points == points.size());
  std::cout << "done" << std::endl;
}
