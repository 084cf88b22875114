// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_PARAMETERS_H
#define CGAL_POINT_SET_FLOW_PARAMETERS_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Named_function_parameters.h>

namespace CGAL {
namespace Point_set_flow {

// The named parameters of this package
#define CGAL_POINT_SET_FLOW_FOR_EACH_PARAMETER(DEFINE)                                             \
  DEFINE(flow)                                                                                     \
  DEFINE(curvature)                                                                                \
  DEFINE(feature_threshold)                                                                        \
  DEFINE(filter_width)                                                                             \
  DEFINE(step_length)                                                                              \
  DEFINE(update_period)                                                                            \
  DEFINE(initial_point_map)                                                                        \
  DEFINE(feature_strength_map)                                                                     \
  DEFINE(block_size)                                                                               \
  DEFINE(noise)                                                                                    \
  DEFINE(scan_map)                                                                                 \
  DEFINE(smoothing_report)

/// \cond SKIP_IN_MANUAL
/// The tags by which named parameters are looked up.
namespace internal_np {
#define CGAL_POINT_SET_FLOW_TAG(NAME)                                                              \
  struct NAME##_t {};
CGAL_POINT_SET_FLOW_FOR_EACH_PARAMETER(CGAL_POINT_SET_FLOW_TAG)
#undef CGAL_POINT_SET_FLOW_TAG
} // namespace internal_np
/// \endcond

/// \ingroup PkgPointSetFlowParameters
/// A pack of named parameters whose last one is of this package. Its members add another one of
/// this package, or, by inheritance, one of \cgal's. What \cgal's return is a pack of \cgal's: this
/// package's parameters come first.
///
/// \cgal has no way to add a named parameter from outside before its release 5.6 (`combine()`);
/// this way works with all releases from 5.5 on. A pack inherits the one before it, therefore the
/// one before is always stored as \cgal's: a member found there would leave out what came between.
template <typename T, typename Tag, typename Base = CGAL::internal_np::No_property>
struct Named_parameters : public Named_function_parameters<T, Tag, Base> {
  typedef Named_function_parameters<T, Tag, Base> Pack; ///< the same as a pack of \cgal's
  using Pack::Pack;

/// \cond SKIP_IN_MANUAL
#define CGAL_POINT_SET_FLOW_MEMBER(NAME)                                                           \
  template <typename K>                                                                            \
  Named_parameters<K, internal_np::NAME##_t, Pack> NAME(const K& value) const                      \
  {                                                                                                \
    return Named_parameters<K, internal_np::NAME##_t, Pack>(value, *this);                         \
  }
  CGAL_POINT_SET_FLOW_FOR_EACH_PARAMETER(CGAL_POINT_SET_FLOW_MEMBER)
#undef CGAL_POINT_SET_FLOW_MEMBER
  /// \endcond
};

} // namespace Point_set_flow

namespace parameters {

// One function for each named parameter; documented in doc/Named_parameters.txt
/// \cond SKIP_IN_MANUAL
#define CGAL_POINT_SET_FLOW_FUNCTION(NAME)                                                         \
  template <typename K>                                                                            \
  Point_set_flow::Named_parameters<K, Point_set_flow::internal_np::NAME##_t> NAME(const K& value)  \
  {                                                                                                \
    return Point_set_flow::Named_parameters<K, Point_set_flow::internal_np::NAME##_t>(value);      \
  }
CGAL_POINT_SET_FLOW_FOR_EACH_PARAMETER(CGAL_POINT_SET_FLOW_FUNCTION)
#undef CGAL_POINT_SET_FLOW_FUNCTION
#undef CGAL_POINT_SET_FLOW_FOR_EACH_PARAMETER
/// \endcond

} // namespace parameters
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_PARAMETERS_H
