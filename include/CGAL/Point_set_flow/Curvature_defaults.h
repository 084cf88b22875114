// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_CURVATURE_DEFAULTS_H
#define CGAL_POINT_SET_FLOW_CURVATURE_DEFAULTS_H

#include <CGAL/license/Point_set_flow.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Point_set_flow {

/// \ingroup PkgPointSetFlowCurvature
/// The parameters that suit a curvature estimator, which returns them from a static member function
/// `defaults()`. One that has no such function gets these, the paper's.
struct Curvature_defaults {
  unsigned int number_of_iterations = 12; ///< the number of steps
  double filter_width = .3;               ///< in neighborhood radii
  double step_length = .75;               ///< without unit
  double sharpness_angle = 30.;           ///< in degrees
  double size_factor = 28.;               ///< see `neighborhood_size()`
  double size_exponent = .5;              ///< see `neighborhood_size()`
  unsigned int smallest_size = 16;        ///< see `neighborhood_size()`
  unsigned int largest_size = 32;         ///< see `neighborhood_size()`

  /// The number of neighbors: `size_factor` times the noise to the power of `size_exponent`, but in
  /// the range from `smallest_size` to `largest_size`. It is chosen for each part of the point set; there
  /// are more neighbors where points lie in lines or columns, which so few do not make a surface.
  /// \param noise the standard deviation of the noise in multiples of the spacing, both around the point
  unsigned int neighborhood_size(double noise) const
  {
    const double size = size_factor * std::pow(noise, size_exponent);
    return static_cast<unsigned int>(
        std::round((std::min)((std::max)(size, double(smallest_size)), double(largest_size))));
  }
};

} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_CURVATURE_DEFAULTS_H
