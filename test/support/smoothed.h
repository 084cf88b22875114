// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_TEST_SMOOTHED_H
#define CGAL_POINT_SET_FLOW_TEST_SMOOTHED_H

#include "shapes.h"

#include <CGAL/balanced_flow_smooth_point_set.h>

namespace shapes {

/// What becomes of points with 20 neighbors and no other parameters
inline Points smoothed(Points points)
{
  CGAL::balanced_flow_smooth_point_set<CGAL::Sequential_tag>(points, 20);
  return points;
}

} // namespace shapes

#endif // CGAL_POINT_SET_FLOW_TEST_SMOOTHED_H
