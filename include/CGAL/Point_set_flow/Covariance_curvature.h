// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_COVARIANCE_CURVATURE_H
#define CGAL_POINT_SET_FLOW_COVARIANCE_CURVATURE_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/Neighborhood_3.h>
#include <CGAL/Point_set_flow/Tangent_plane_3.h>
#include <CGAL/Point_set_flow/internal/fitting/Covariance_3.h>

#include <cstddef>

namespace CGAL {
namespace Point_set_flow {

/// \ingroup PkgPointSetFlowCurvature
/// The curvature of the paper, by covariance analysis: equations (1), (2) and (3).
///
/// The surface variation has no unit, but equation (4) uses it as a speed. So that the result does not
/// depend on the unit of the data, the directional curvature is
/// \f$\bar\kappa_i = \mathrm{sign}\cdot\sigma_n\cdot r\f$ with the neighborhood radius \f$r\f$.
///
/// \cgalModels{PointSetCurvature}
class Covariance_curvature {
public:
  /// Equations (1) and (2).
  Tangent_plane_3 tangent_plane(const Neighborhood_3& neighborhood) const
  {
    const internal::Smallest_eigenpair_3 pair =
        internal::smallest_eigenpair(internal::Covariance_3(neighborhood));
    return {pair.vector, pair.variation};
  }

  /// Equation (4), the sign from equation (3).
  double directional_curvature(const Neighborhood_3& neighborhood,
                               const Tangent_plane_3& plane) const
  {
    const double sign = direction(neighborhood, plane.normal) >= 0. ? 1. : -1.;
    return sign * plane.variation * neighborhood.radius();
  }

  /// Dire of equation (3): the Gaussian-weighted mean of \f$(n, p - u)\f$ over the neighbors \f$u\f$
  static double direction(const Neighborhood_3& neighborhood, const Vector_3& normal)
  {
    double sum = 0., weights = 0.;
    for (std::size_t j = 0; j < neighborhood.size(); ++j) {
      const Vector_3 d = neighborhood.center() - neighborhood[j];
      const double weight = neighborhood.gaussian(d.squared_length());
      sum += weight * (normal * d);
      weights += weight;
    }
    return weights > 0. ? sum / weights : 0.;
  }
};

} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_COVARIANCE_CURVATURE_H
