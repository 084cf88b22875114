// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FLOW_MODEL_TRAITS_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FLOW_MODEL_TRAITS_H

#include <CGAL/Point_set_flow/Tangent_plane_curvature.h>
#include <CGAL/Point_set_flow/flows.h>

#include <type_traits>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// Whether a flow looks at the prefiltered surface: it does unless it says no.
template <typename Flow, typename = void>
struct Uses_prefilter : std::true_type {};
template <typename Flow>
struct Uses_prefilter<Flow, std::void_t<typename Flow::Uses_prefilter>>
    : std::bool_constant<Flow::Uses_prefilter::value> {};

/// Whether an estimator looks at the normals of the step before: it does if it says so.
template <typename Curvature, typename = void>
struct Uses_normals : std::false_type {};
template <typename Curvature>
struct Uses_normals<Curvature, std::void_t<typename Curvature::Uses_normals>>
    : std::bool_constant<Curvature::Uses_normals::value> {};

/// Whether points are kept from going farther than their neighbors, in all steps together. The
/// default does not need more, and gets no worse in degenerate places; other flows go where they go.
template <typename Flow, typename Curvature>
struct Stays_in_neighborhood
    : std::bool_constant<std::is_same<Flow, Balanced_flow>::value &&
                         std::is_same<Curvature, Tangent_plane_curvature>::value> {};

/// The parameters that suit an estimator.
template <typename Curvature, typename = void>
struct Defaults_of {
  static Curvature_defaults get() { return Curvature_defaults(); }
};
template <typename Curvature>
struct Defaults_of<Curvature, std::void_t<decltype(Curvature::defaults())>> {
  static Curvature_defaults get() { return Curvature::defaults(); }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FLOW_MODEL_TRAITS_H
