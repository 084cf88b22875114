// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_TEST_SMOOTHED_H
#define CGAL_POINT_SET_FLOW_TEST_SMOOTHED_H

#include "shapes.h"

#include <CGAL/balanced_flow_smooth_point_set.h>

/// What becomes of points with 20 neighbors and no other parameters
inline shapes::Points smoothed(shapes::Points points)
{
  CGAL::balanced_flow_smooth_point_set<CGAL::Sequential_tag>(points, 20);
  return points;
}

#endif // CGAL_POINT_SET_FLOW_TEST_SMOOTHED_H
