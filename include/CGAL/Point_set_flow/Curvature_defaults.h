// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_CURVATURE_DEFAULTS_H
#define CGAL_POINT_SET_FLOW_CURVATURE_DEFAULTS_H

#include <CGAL/Point_set_flow/Core_kernel.h>

namespace CGAL {
namespace Point_set_flow {

/// \ingroup PkgPointSetFlowCurvature
/// The plane through a point that an estimator fits to its neighborhood.
struct Tangent_plane_3 {
  Vector_3 normal;  ///< a unit vector; its side does not matter
  double variation; ///< without unit, at least 0, 0 where the surface is flat
};

/// \ingroup PkgPointSetFlowCurvature
/// What a curvature estimator says of one point.
struct Curvature_3 {
  Vector_3 normal;              ///< a unit vector; its side does not matter
  double variation;             ///< without unit, at least 0, 0 where the surface is flat
  double directional_curvature; ///< a length, signed along `normal`
};

/// \ingroup PkgPointSetFlowCurvature
/// The parameters that suit a curvature estimator. It tells them by a static member function
/// `defaults()`; one that has none gets these, the paper's.
struct Curvature_defaults {
  unsigned int number_of_iterations = 12; ///< the number of steps
  double filter_width = .3;               ///< in neighborhood radii
  double step_length = .75;               ///< without unit
  double sharpness_angle = 30.;           ///< in degrees
  /// the number of neighbors is this times noise / spacing to the power of `size_exponent`, but in
  /// the range from `smallest_size` to `largest_size`
  double size_factor = 28.;
  double size_exponent = .5;       ///< see `size_factor`
  unsigned int smallest_size = 16; ///< see `size_factor`
  unsigned int largest_size = 32;  ///< see `size_factor`
};

} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_CURVATURE_DEFAULTS_H
