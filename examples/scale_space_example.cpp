// SPDX-License-Identifier: GPL-3.0-or-later
// Scale space reconstruction: triangles of the smoothed points, which are as well triangles of the
// points of the scan, for these keep their numbers.
//   scale_space_example [scan] [smooth_mesh.off] [mesh_of_scan.off]
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/IO/read_points.h>
#include <CGAL/Scale_space_reconstruction_3/Advancing_front_mesher.h>
#include <CGAL/Scale_space_reconstruction_3/Balanced_flow_smoother.h>
#include <CGAL/Scale_space_surface_reconstruction_3.h>

#include <array>
#include <iostream>
#include <string>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Scale_space_surface_reconstruction_3<Kernel> Reconstruction;
typedef CGAL::Scale_space_reconstruction_3::Advancing_front_mesher<Kernel> Mesher;
typedef CGAL::Scale_space_reconstruction_3::Balanced_flow_smoother<Kernel> Smoother;

int main(int argc, char** argv)
{
  const std::string scan = argc > 1 ? argv[1] : CGAL::data_file_path("points_3/oni.ply");
  std::vector<Kernel::Point_3> points;
  if (!CGAL::IO::read_points(scan, std::back_inserter(points)) || points.empty()) {
    std::cerr << "cannot read " << scan << std::endl;
    return EXIT_FAILURE;
  }

  Reconstruction reconstruction(points.begin(), points.end());
  reconstruction.increase_scale<Smoother>(); // once: the smoother knows how much noise there is
  reconstruction.reconstruct_surface(Mesher());

  const std::vector<std::array<std::size_t, 3>> triangles(reconstruction.facets_begin(),
                                                          reconstruction.facets_end());
  const std::vector<Kernel::Point_3> smooth(reconstruction.points_begin(),
                                            reconstruction.points_end());
  std::cout << points.size() << " points, " << triangles.size() << " triangles" << std::endl;
  return CGAL::IO::write_polygon_soup(argc > 2 ? argv[2] : "smooth_scale.off", smooth, triangles) &&
                 CGAL::IO::write_polygon_soup(argc > 3 ? argv[3] : "scan_scale.off", points,
                                              triangles)
             ? EXIT_SUCCESS
             : EXIT_FAILURE;
}
