// SPDX-License-Identifier: GPL-3.0-or-later
/*!
\ingroup PkgPointSetFlowConcepts
\cgalConcept

The concept `PointSetFlow` describes the right-hand side \f$\partial u / \partial t\f$ of an
evolution equation.

It is passed to `CGAL::balanced_flow_smooth_point_set()` with the named parameter `flow`. A lambda can
be a model. A flow is copied, not kept by reference, and with `CGAL::Parallel_tag` it is called from
several threads at once.

For the result to scale with the data, the motion must scale with the lengths in `u`.

`CGAL::Point_set_flow::Any_flow` erases the type of a flow, for example to select one at run time, and
keeps its properties; a `std::function` does not. A model whose properties are only known at run time
has the member functions `bool uses_prefilter() const`, `bool stays_in_neighborhood() const` and
`bool is_correctable() const` instead of the member types.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Point_set_flow::Curvature_flow}
\cgalHasModels{CGAL::Point_set_flow::Anisotropic_flow}
\cgalHasModels{CGAL::Point_set_flow::Well_posed_anisotropic_flow}
\cgalHasModels{CGAL::Point_set_flow::Volume_preserving_flow}
\cgalHasModels{CGAL::Point_set_flow::Balanced_flow}
\cgalHasModels{CGAL::Point_set_flow::Any_flow}
\cgalHasModelsEnd
*/
class PointSetFlow {
public:
  /// Optional: `CGAL::Tag_true` (also if missing) if `u.filtered_variation` is used. With
  /// `CGAL::Tag_false` the prefilter is not run, and `u.filtered_variation` is equal to `u.variation`.
  typedef unspecified_type Uses_prefilter;

  /// Optional: `CGAL::Tag_true` to declare that points are to stay in their neighborhoods. If the
  /// estimator declares it too, the function guarantees that no point moves farther than the distance
  /// of its farthest neighbor. `CGAL::Tag_false` if missing.
  typedef unspecified_type Stays_in_neighborhood;

  /// Optional: `CGAL::Tag_true` to declare that the flow ends where the surface is, so that an estimator that
  /// declares `number_of_corrections` may correct the result. With an estimator that uses the surface estimate,
  /// points without noise that are at their reference points are not moved. `CGAL::Tag_false` if missing.
  typedef unspecified_type Is_correctable;

  /// returns the motion of the point `u` in one step of length 1, in the unit of the data. `g` is
  /// the diffusivity, a function of the surface variation.
  CGAL::Point_set_flow::Vector_3 operator()(const CGAL::Point_set_flow::Flow_point_3& u,
                                            const CGAL::Point_set_flow::Diffusivity& g) const;
};
