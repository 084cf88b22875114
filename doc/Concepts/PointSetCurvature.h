// SPDX-License-Identifier: GPL-3.0-or-later
/*!
\ingroup PkgPointSetFlowConcepts
\cgalConcept

The concept `PointSetCurvature` describes an estimator of the normal and the curvature of a surface
at a point with its neighbors.

It is passed to `CGAL::balanced_flow_smooth_point_set()` with the named parameter `curvature`. It must
be copyable, and with `CGAL::Parallel_tag` it is called from several threads at once.

The points come in the unit of the data, moved to the origin. (Only where coordinates differ by
less than \f$10^{-100}\f$ or more than \f$10^{100}\f$ they come scaled by a power of 2: lengths
that are returned must scale with the points.)

Each step of the flow first asks for the tangent planes of all points, and then for the curvatures.
- If the nested type `Uses_normals` is `CGAL::Tag_true`, the tangent planes are those of the points
  as they are, and the normals and the noise around the point are known. `tangent_plane()` sees the
  normals of the step before, none in the first step; `operator()()` sees the new ones.
- If it is `CGAL::Tag_false`, or missing, the tangent planes are those of the prefiltered points,
  and only their variation is used, for the diffusivity.

A static member function `defaults()` may return the parameters that suit the estimator.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Point_set_flow::Tangent_plane_curvature}
\cgalHasModels{CGAL::Point_set_flow::Covariance_curvature}
\cgalHasModelsEnd
*/
class PointSetCurvature {
public:
  /// whether the estimator looks at normals and noise; optional
  typedef unspecified_type Uses_normals;

  /// returns the parameters that suit the estimator; optional
  static CGAL::Point_set_flow::Curvature_defaults defaults();

  /// returns the normal, the variation and the directional curvature
  CGAL::Point_set_flow::Curvature_3 operator()(const CGAL::Point_set_flow::Neighborhood_3& neighborhood) const;

  /// returns the normal and the variation
  CGAL::Point_set_flow::Tangent_plane_3 tangent_plane(const CGAL::Point_set_flow::Neighborhood_3& neighborhood) const;
};
