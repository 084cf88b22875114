// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_ORDER_INPUT_POINTS_H
#define CGAL_POINT_SET_FLOW_INTERNAL_ORDER_INPUT_POINTS_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/Core_kernel.h>
#include <CGAL/Point_set_flow/internal/order/Given_noise.h>
#include <CGAL/Point_set_flow/internal/parallel/Array.h>

#include <cstdint>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// What the caller gives, in the order of the caller and the coordinates of the core
struct Input_points {
  Array<Point_3> reference;      ///< \f$I\f$
  Array<Point_3> start;          ///< \f$\chi\f$; empty if it is the reference
  std::vector<char> constrained; ///< which points must not move; empty if all may
  Given_noise noise;
  Array<Vector_3> sides;      ///< unit normals, null where not known; empty if none is
  Array<std::uint32_t> scans; ///< empty if not given
  Array<double> clearance;    ///< see `Clearance`; empty if the point set is whole
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_ORDER_INPUT_POINTS_H
