// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_CORE_KERNEL_H
#define CGAL_POINT_SET_FLOW_CORE_KERNEL_H

#include <CGAL/license/Point_set_flow.h>

// Infinite and NaN coordinates are recognized, and results do not depend on threads or compilers:
// neither is true where the compiler may do as if there were no such numbers.
#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
#error "balanced_flow_smooth_point_set() must not be compiled with -ffast-math, -ffinite-math-only"
#endif

#if !__has_include(<Eigen/Core>)
#error "balanced_flow_smooth_point_set() needs Eigen 3.3 or newer (Debian: libeigen3-dev)"
#endif

#include <CGAL/Simple_cartesian.h>

namespace CGAL {
namespace Point_set_flow {

/// \addtogroup PkgPointSetFlowFlows
/// @{

/// The geometry of the numeric core: whatever the kernel of the caller, also with `float`
/// coordinates, the flow is computed in double precision.
typedef Simple_cartesian<double> Core_kernel;
typedef Core_kernel::Point_3 Point_3;   ///< a point of the core
typedef Core_kernel::Vector_3 Vector_3; ///< a vector of the core
/// @}

} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_CORE_KERNEL_H
