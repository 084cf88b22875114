// SPDX-License-Identifier: GPL-3.0-or-later
// Poisson reconstruction of a closed object: remove outliers, smooth and get normals, orient them,
// reconstruct.
//   poisson_example [scan] [mesh.off]
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/read_points.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/balanced_flow_smooth_point_set.h>
#include <CGAL/compute_average_spacing.h>
#include <CGAL/mst_orient_normals.h>
#include <CGAL/poisson_surface_reconstruction.h>
#include <CGAL/remove_outliers.h>

#include <iostream>
#include <string>
#include <utility>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef std::pair<Kernel::Point_3, Kernel::Vector_3> Point_with_normal;
typedef CGAL::First_of_pair_property_map<Point_with_normal> Point_map;
typedef CGAL::Second_of_pair_property_map<Point_with_normal> Normal_map;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef CGAL::Parallel_if_available_tag Concurrency_tag;

int main(int argc, char** argv)
{
  const std::string scan = argc > 1 ? argv[1] : CGAL::data_file_path("points_3/oni.pwn");
  std::vector<Point_with_normal> points;
  if (!CGAL::IO::read_points(scan, std::back_inserter(points),
                             CGAL::parameters::point_map(Point_map()).normal_map(Normal_map()))) {
    std::cerr << "cannot read " << scan << std::endl;
    return EXIT_FAILURE;
  }

  const auto outliers = CGAL::remove_outliers<Concurrency_tag>(
      points, 24, CGAL::parameters::threshold_percent(1.).point_map(Point_map()));
  points.erase(outliers, points.end());

  const auto maps = CGAL::parameters::point_map(Point_map()).normal_map(Normal_map());
  CGAL::balanced_flow_smooth_point_set<Concurrency_tag>(points, maps);

  // Only if the scan had no normals: those given keep their sides
  if (points.front().second == CGAL::NULL_VECTOR)
    CGAL::mst_orient_normals(points, 18, maps);

  const double spacing = CGAL::compute_average_spacing<Concurrency_tag>(points, 6, maps);
  Mesh mesh;
  if (!CGAL::poisson_surface_reconstruction_delaunay(points.begin(), points.end(), Point_map(),
                                                     Normal_map(), mesh, spacing)) {
    std::cerr << "no surface" << std::endl;
    return EXIT_FAILURE;
  }
  std::cout << points.size() << " points, " << mesh.number_of_faces() << " triangles" << std::endl;
  return CGAL::IO::write_polygon_mesh(argc > 2 ? argv[2] : "poisson.off", mesh) ? EXIT_SUCCESS
                                                                                : EXIT_FAILURE;
}
