// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/read_points.h>
#include <CGAL/IO/write_points.h>
#include <CGAL/balanced_flow_smooth_point_set.h>

#include <iostream>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel::Point_3 Point_3;

int main(int argc, char** argv)
{
  const std::string input = argc > 1 ? argv[1] : CGAL::data_file_path("points_3/kitten.xyz");
  std::vector<Point_3> points;
  if (!CGAL::IO::read_points(input, std::back_inserter(points))) {
    std::cerr << "cannot read " << input << std::endl;
    return EXIT_FAILURE;
  }

  CGAL::balanced_flow_smooth_point_set<CGAL::Parallel_if_available_tag>(points);

  return CGAL::IO::write_points("smoothed.xyz", points) ? EXIT_SUCCESS : EXIT_FAILURE;
}
