// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_POINT_SET_SCALE_H
#define CGAL_POINT_SET_FLOW_POINT_SET_SCALE_H

#include <CGAL/license/Point_set_flow.h>

namespace CGAL {
namespace Point_set_flow {

/// \ingroup PkgPointSetFlowFunctions
/// The noise and the spacing of a point set, medians of the estimates around its points, and the
/// neighborhood size that suits them.
struct Point_set_scale {
  /// the standard deviation of the distance to the surface, in the unit of the data: the median
  double noise = 0.;
  /// the square root of the surface area per point, in the unit of the data: the median
  double spacing = 0.;
  /// the number of neighbors that suits this noise and this spacing. If `k` is omitted,
  /// `balanced_flow_smooth_point_set()` chooses it in the same way, but for each part of the point set
  /// from the noise and the spacing there.
  unsigned int k = 24;
};

} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_POINT_SET_SCALE_H
