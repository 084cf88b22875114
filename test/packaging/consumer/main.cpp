// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Point_set_flow/estimate_point_set_scale.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/balanced_flow_smooth_point_set.h>

#include <cstdlib>
#include <vector>

typedef CGAL::Simple_cartesian<double>::Point_3 Point_3;

double smooth_elsewhere(std::vector<Point_3>& points); // in other.cpp

int main()
{
  std::vector<Point_3> points;
  for (int i = 0; i < 10; ++i)
    for (int j = 0; j < 10; ++j)
      points.emplace_back(i, j, (i * j) % 3 * .5);
  std::vector<Point_3> copy = points;
  const double here =
      CGAL::balanced_flow_smooth_point_set<CGAL::Parallel_if_available_tag>(points, 12);
  return here > 0. && here == smooth_elsewhere(copy) && points == copy ? EXIT_SUCCESS
                                                                       : EXIT_FAILURE;
}
