// SPDX-License-Identifier: GPL-3.0-or-later
/*!
\ingroup PkgBalancedFlowConcepts
\cgalConcept

The concept `PointSetCurvature` describes an estimator of the normal and the curvature of a surface
at a point with its neighbors, as it is passed to `CGAL::balanced_flow_smooth_point_set()` with the
named parameter `curvature`. It must be copyable, and with `CGAL::Parallel_tag` it is called from
several threads at once.

The points come in the unit of the data, moved to the origin. (Only where coordinates differ by
less than \f$10^{-100}\f$ or more than \f$10^{100}\f$ they come scaled by a power of 2: lengths
that are returned must scale with the points.)

\cgalHasModel `CGAL::Point_set_flow::Covariance_curvature`
*/
class PointSetCurvature {
public:
  /// returns the normal, the variation and the directional curvature
  CGAL::Point_set_flow::Curvature_3 operator()(const CGAL::Point_set_flow::Neighborhood_3& neighborhood) const;

  /// returns the variation alone, of the prefiltered surface
  double variation(const CGAL::Point_set_flow::Neighborhood_3& neighborhood) const;
};
