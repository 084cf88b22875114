// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FLOW_MODEL_TRAITS_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FLOW_MODEL_TRAITS_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/Curvature_defaults.h>

#include <type_traits>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

// Properties that models of PointSetFlow and PointSetCurvature declare: by a nested type or, if they
// are known at run time only, by a member function.

/// Whether a flow looks at the variation of the prefiltered surface. It does unless declared otherwise.
template <typename Flow, typename = void>
struct Uses_prefilter : std::true_type {};
template <typename Flow>
struct Uses_prefilter<Flow, std::void_t<typename Flow::Uses_prefilter>>
    : std::bool_constant<Flow::Uses_prefilter::value> {};

template <typename Flow>
auto uses_prefilter(const Flow& flow, int) -> decltype(flow.uses_prefilter())
{
  return flow.uses_prefilter();
}
template <typename Flow>
bool uses_prefilter(const Flow&, long)
{
  return Uses_prefilter<Flow>::value;
}
template <typename Flow>
bool uses_prefilter(const Flow& flow)
{
  return uses_prefilter(flow, 0);
}

/// Whether a flow or an estimator keeps points within their neighborhoods. Must be declared.
template <typename Model, typename = void>
struct Stays_in_neighborhood : std::false_type {};
template <typename Model>
struct Stays_in_neighborhood<Model, std::void_t<typename Model::Stays_in_neighborhood>>
    : std::bool_constant<Model::Stays_in_neighborhood::value> {};

template <typename Model>
auto stays_in_neighborhood(const Model& model, int) -> decltype(model.stays_in_neighborhood())
{
  return model.stays_in_neighborhood();
}
template <typename Model>
bool stays_in_neighborhood(const Model&, long)
{
  return Stays_in_neighborhood<Model>::value;
}
template <typename Model>
bool stays_in_neighborhood(const Model& model)
{
  return stays_in_neighborhood(model, 0);
}

/// Whether an estimator uses the normals of the neighbors and the noise. Must be
/// declared.
template <typename Curvature, typename = void>
struct Uses_surface_estimate : std::false_type {};
template <typename Curvature>
struct Uses_surface_estimate<Curvature, std::void_t<typename Curvature::Uses_surface_estimate>>
    : std::bool_constant<Curvature::Uses_surface_estimate::value> {};

/// Whether an estimator may correct the result of a flow. Must be declared.
template <typename Flow, typename = void>
struct Is_correctable : std::false_type {};
template <typename Flow>
struct Is_correctable<Flow, std::void_t<typename Flow::Is_correctable>>
    : std::bool_constant<Flow::Is_correctable::value> {};

template <typename Flow>
auto is_correctable(const Flow& flow, int) -> decltype(flow.is_correctable())
{
  return flow.is_correctable();
}
template <typename Flow>
bool is_correctable(const Flow&, long)
{
  return Is_correctable<Flow>::value;
}
template <typename Flow>
bool is_correctable(const Flow& flow)
{
  return is_correctable(flow, 0);
}

/// How often an estimator corrects the result of the flow. Must be declared.
template <typename Curvature, typename = void>
struct Number_of_corrections : std::integral_constant<unsigned int, 0> {};
template <typename Curvature>
struct Number_of_corrections<Curvature, std::void_t<decltype(Curvature::number_of_corrections)>>
    : std::integral_constant<unsigned int, Curvature::number_of_corrections> {};

/// In how many rounds an estimator finds sheets. Must be declared.
template <typename Curvature, typename = void>
struct Number_of_sheet_rounds : std::integral_constant<unsigned int, 0> {};
template <typename Curvature>
struct Number_of_sheet_rounds<Curvature, std::void_t<decltype(Curvature::number_of_sheet_rounds)>>
    : std::integral_constant<unsigned int, Curvature::number_of_sheet_rounds> {};

/// The parameters that suit an estimator
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
