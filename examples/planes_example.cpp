// SPDX-License-Identifier: GPL-3.0-or-later
// Planes in a LiDAR scan: smooth and get normals, detect, and measure the planes on the points of
// the scan.
//   planes_example [scan]
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/read_points.h>
#include <CGAL/Shape_detection/Efficient_RANSAC.h>
#include <CGAL/balanced_flow_smooth_point_set.h>
#include <CGAL/estimate_point_set_noise.h>

#include <cmath>
#include <iostream>
#include <string>
#include <tuple>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
// the point, its normal, and the point as it was scanned
typedef std::tuple<Kernel::Point_3, Kernel::Vector_3, Kernel::Point_3> Scan_point;
typedef std::vector<Scan_point> Points;
typedef CGAL::Nth_of_tuple_property_map<0, Scan_point> Point_map;
typedef CGAL::Nth_of_tuple_property_map<1, Scan_point> Normal_map;
typedef CGAL::Shape_detection::Efficient_RANSAC_traits<Kernel, Points, Point_map, Normal_map>
    Traits;
typedef CGAL::Shape_detection::Efficient_RANSAC<Traits> Ransac;
typedef CGAL::Shape_detection::Plane<Traits> Plane;
typedef CGAL::Parallel_if_available_tag Concurrency_tag;

int main(int argc, char** argv)
{
  const std::string file = argc > 1 ? argv[1] : CGAL::data_file_path("points_3/b9_training.ply");
  const auto maps = CGAL::parameters::point_map(Point_map()).normal_map(Normal_map());
  Points points;
  if (!CGAL::IO::read_points(file, std::back_inserter(points), maps) || points.empty()) {
    std::cerr << "cannot read " << file << std::endl;
    return EXIT_FAILURE;
  }
  for (Scan_point& p : points)
    std::get<2>(p) = std::get<0>(p);
  const double noise = CGAL::estimate_point_set_noise<Concurrency_tag>(points, maps);

  CGAL::balanced_flow_smooth_point_set<Concurrency_tag>(points, maps);

  Ransac ransac;
  ransac.set_input(points); // reorders them
  ransac.add_shape_factory<Plane>();
  Ransac::Parameters parameters;
  parameters.min_points = 100;
  parameters.epsilon = 3. * noise;
  parameters.normal_threshold = .9;
  ransac.detect(parameters);

  double sum = 0.;
  std::size_t count = 0;
  for (const auto& shape : ransac.shapes())
    for (const std::size_t i : shape->indices_of_assigned_points()) {
      sum += shape->squared_distance(std::get<2>(points[i]));
      ++count;
    }
  std::cout << ransac.shapes().size() << " planes with " << count << " of " << points.size()
            << " points, rms distance of the scan from them " << std::sqrt(sum / double(count))
            << std::endl;
  return count > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
