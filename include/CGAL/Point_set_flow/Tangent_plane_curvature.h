// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_TANGENT_PLANE_CURVATURE_H
#define CGAL_POINT_SET_FLOW_TANGENT_PLANE_CURVATURE_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/Curvature_defaults.h>
#include <CGAL/Point_set_flow/Neighborhood_3.h>
#include <CGAL/Point_set_flow/Tangent_plane_3.h>
#include <CGAL/Point_set_flow/internal/fitting/Same_side.h>
#include <CGAL/Point_set_flow/internal/fitting/fit_tangent_plane.h>
#include <CGAL/Point_set_flow/internal/fitting/plane_distances.h>
#include <CGAL/tags.h>

namespace CGAL {
namespace Point_set_flow {

/// \ingroup PkgPointSetFlowCurvature
/// The directional curvature as the distance of a point from the tangent planes of its
/// neighborhood, with weights that respect features. The default.
///
/// The distance of \f$p_i\f$ from a neighbor \f$p_j\f$ is taken along both normals,
/// \f$d_j = \frac12 [(p_i - p_j) \cdot n_i \pm (p_i - p_j) \cdot n_j]\f$. On a sphere the two terms
/// differ in sign only, so that the mean does not shrink a curved surface, as equation (3) does. The
/// directional curvature \f$\bar\kappa_i\f$ is the mean of the \f$d_j\f$, weighted by
/// - the distance of the neighbor,
/// - the angle between the two normals, and
/// - \f$d_j\f$ itself, against the noise: what lies farther off belongs to another sheet.
///
/// The last two become stricter from the first step to the last: first the noise must not be taken
/// for features, in the end features must not be taken for noise. The normals come from the
/// covariance, equation (1), with the same kind of weights.
///
/// Without normals, in the first step, the weights are Gaussians of the distance alone. Neighbors that are
/// known to be on the opposite side of the surface have no weight.
///
/// \cgalModels{PointSetCurvature}
class Tangent_plane_curvature {
public:
  /// uses the normals of the step before, and the noise
  typedef Tag_true Uses_surface_estimate;
  /// directional curvatures are means of distances, limited by the noise
  typedef Tag_true Stays_in_neighborhood;

  /// 5 steps, and 60 (noise / spacing)^0.7 neighbors, from 24 to 128
  static Curvature_defaults defaults()
  {
    Curvature_defaults d;
    d.number_of_iterations = 5;
    d.filter_width = .6;
    d.step_length = .75;
    d.sharpness_angle = 60.;
    d.size_factor = 60., d.size_exponent = .7;
    d.smallest_size = 24, d.largest_size = 128;
    return d;
  }

  /// Equation (1) with weights. The variation, equation (2), is what the noise does not explain.
  Tangent_plane_3 tangent_plane(const Neighborhood_3& neighborhood) const
  {
    if (neighborhood.is_sided())
      return tangent_plane_of_side(neighborhood);
    return neighborhood.has_normals() ? internal::fit_tangent_plane<true>(neighborhood)
                                      : internal::fit_tangent_plane<false>(neighborhood);
  }

  /// The weighted mean of the \f$d_j\f$, no longer than the noise allows.
  /// \pre `neighborhood.has_normals()`
  double directional_curvature(const Neighborhood_3& neighborhood, const Tangent_plane_3&) const
  {
    if (neighborhood.is_sided())
      return internal::mean_plane_distance(internal::Same_side(neighborhood).neighborhood());
    return internal::mean_plane_distance(neighborhood);
  }

private:
  Tangent_plane_3 tangent_plane_of_side(const Neighborhood_3& neighborhood) const
  {
    const internal::Same_side same(neighborhood);
    if (same.neighborhood().size() >= 2)
      return tangent_plane(same.neighborhood());
    return {neighborhood.has_normals() ? neighborhood.normal() : neighborhood.side(), 0.};
  }
};

} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_TANGENT_PLANE_CURVATURE_H
