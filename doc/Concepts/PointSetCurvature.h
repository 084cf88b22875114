// SPDX-License-Identifier: GPL-3.0-or-later
/*!
\ingroup PkgPointSetFlowConcepts
\cgalConcept

The concept `PointSetCurvature` describes an estimator of the tangent plane and the directional
curvature of a surface at a point, given its neighbors.

It is passed to `CGAL::balanced_flow_smooth_point_set()` with the named parameter `curvature`. It must
be copyable, and with `CGAL::Parallel_tag` it is called from several threads at once.

In every step `directional_curvature()` is called for each point with the tangent plane that
`tangent_plane()` returned for it. If the estimator declares `Uses_surface_estimate`, the planes of all
points are computed first, and the neighborhood also has the noise around the point and the normals: those
of the previous step in `tangent_plane()`, none in the first step, and those of the current step in
`directional_curvature()`. Where the caller gave normals that can be trusted, it also tells which neighbors are on
the opposite side of a thin wall. Neither function is called for points with fewer than two neighbors. For a flow
that uses the prefilter, `tangent_plane()` is also called for the prefiltered surface, unless the estimator
uses the surface estimate.

The coordinates are in the unit of the data, relative to an origin near the points. (Only if the extent
of the points is less than \f$10^{-100}\f$ or more than \f$10^{140}\f$ are they scaled, by a power of 2:
returned lengths must scale with the points.)

A static member function `defaults()` may return the parameters that suit the estimator.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Point_set_flow::Learned_curvature}
\cgalHasModels{CGAL::Point_set_flow::Tangent_plane_curvature}
\cgalHasModels{CGAL::Point_set_flow::Covariance_curvature}
\cgalHasModelsEnd
*/
class PointSetCurvature {
public:
  /// Optional: `CGAL::Tag_true` if the estimator uses the normals of the neighbors and the noise. The
  /// variation of its tangent planes must then be what the noise does not explain; it is used for the
  /// diffusivity as it is. With `CGAL::Tag_false`, or if missing, the diffusivity of a flow with
  /// `PointSetFlow::Uses_prefilter` uses the variation of the prefiltered surface.
  typedef unspecified_type Uses_surface_estimate;

  /// Optional: `CGAL::Tag_true` to declare that points are to stay in their neighborhoods. If the flow
  /// declares it too, the function guarantees that no point moves farther than the distance of its
  /// farthest neighbor. `CGAL::Tag_false` if missing.
  typedef unspecified_type Stays_in_neighborhood;

  /// Optional: how often `find_sheets()` is called for each point before the first step, after the tangent planes.
  /// Each time it sees what was found of the neighbors before. 0 if missing.
  static constexpr unsigned int number_of_sheet_rounds;

  /// Optional: how often `correction()` is called for each point after the last step of a flow that declares
  /// `PointSetFlow::Is_correctable`. 0 if missing.
  static constexpr unsigned int number_of_corrections;

  /// returns the parameters that suit the estimator; optional
  static CGAL::Point_set_flow::Curvature_defaults defaults();

  /// returns the unit normal, whose orientation is arbitrary, and the surface variation
  CGAL::Point_set_flow::Tangent_plane_3
  tangent_plane(const CGAL::Point_set_flow::Neighborhood_3& neighborhood) const;

  /// returns the directional curvature, a length, signed along the normal of `plane`
  double directional_curvature(const CGAL::Point_set_flow::Neighborhood_3& neighborhood,
                               const CGAL::Point_set_flow::Tangent_plane_3& plane) const;

  /// returns whether the neighbors are those of two sheets, and on which one the point is.
  /// Required with `number_of_sheet_rounds`. `neighborhood` has the normals, `Neighborhood_3::sheets()`,
  /// `Neighborhood_3::deviation()` and `Neighborhood_3::excess_kurtosis()`.
  CGAL::Point_set_flow::Sheet_evidence
  find_sheets(const CGAL::Point_set_flow::Neighborhood_3& neighborhood, unsigned int round) const;

  /// returns how far the point is to move along its normal, a length. Required with
  /// `number_of_corrections`. `neighborhood` has the normals and `Neighborhood_3::residual()`.
  double correction(const CGAL::Point_set_flow::Neighborhood_3& neighborhood,
                    unsigned int round) const;
};
