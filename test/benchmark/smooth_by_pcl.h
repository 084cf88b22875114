// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_BENCHMARK_SMOOTH_BY_PCL_H
#define POINT_SET_FLOW_BENCHMARK_SMOOTH_BY_PCL_H

#include "measure/Surface.h"

namespace comparison {

/// Moving least squares of order 2 by the Point Cloud Library, with the neighbors in a ball
void smooth_by_pcl(Points& points, double radius, unsigned int threads);

} // namespace comparison

#endif // POINT_SET_FLOW_BENCHMARK_SMOOTH_BY_PCL_H
