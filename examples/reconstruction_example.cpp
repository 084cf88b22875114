// SPDX-License-Identifier: GPL-3.0-or-later
// A full pipeline: read a scan, remove outliers, smooth, reconstruct, write a mesh.
//   reconstruction_example [scan] [mesh.off] [--raw]     (--raw leaves out the smoothing)
#include <CGAL/Advancing_front_surface_reconstruction.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/IO/read_points.h>
#include <CGAL/balanced_flow_smooth_point_set.h>
#include <CGAL/remove_outliers.h>

#include <array>
#include <iostream>
#include <string>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel::Point_3 Point_3;
typedef CGAL::Parallel_if_available_tag Concurrency_tag;

int main(int argc, char** argv)
{
  const std::string scan = argc > 1 ? argv[1] : CGAL::data_file_path("points_3/hippo1.ply");
  const std::string mesh = argc > 2 ? argv[2] : "mesh.off";
  const bool raw = argc > 3 && std::string(argv[3]) == "--raw";

  std::vector<Point_3> points;
  if (!CGAL::IO::read_points(scan, std::back_inserter(points)) || points.empty()) {
    std::cerr << "cannot read " << scan << std::endl;
    return EXIT_FAILURE;
  }

  points.erase(
      CGAL::remove_outliers<Concurrency_tag>(points, 24, CGAL::parameters::threshold_percent(1.)),
      points.end());
  if (!raw)
    CGAL::balanced_flow_smooth_point_set<Concurrency_tag>(points);

  std::vector<std::array<std::size_t, 3>> triangles;
  CGAL::advancing_front_surface_reconstruction(points.begin(), points.end(),
                                               std::back_inserter(triangles));
  std::cout << points.size() << " points, " << triangles.size() << " triangles" << std::endl;
  return CGAL::IO::write_polygon_soup(mesh, points, triangles) ? EXIT_SUCCESS : EXIT_FAILURE;
}
