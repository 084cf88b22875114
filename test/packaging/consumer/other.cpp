// SPDX-License-Identifier: GPL-3.0-or-later
// The second translation unit: whatever the headers define twice stops the linker here.
#include <CGAL/Point_set_flow/estimate_point_set_scale.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/balanced_flow_smooth_point_set.h>

#include <vector>

double smooth_elsewhere(std::vector<CGAL::Simple_cartesian<double>::Point_3>& points)
{
  return CGAL::balanced_flow_smooth_point_set<CGAL::Sequential_tag>(points, 12);
}
