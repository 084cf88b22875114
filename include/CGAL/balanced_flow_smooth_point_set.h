// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BALANCED_FLOW_SMOOTH_POINT_SET_H
#define CGAL_BALANCED_FLOW_SMOOTH_POINT_SET_H

#include <CGAL/Balanced_flow/internal/smooth_point_set.h>

namespace CGAL {
namespace Point_set_flow {
namespace internal {
template <typename T, typename Tag, typename Base>
std::true_type test_named_parameters(const Named_function_parameters<T, Tag, Base>*);
std::false_type test_named_parameters(const void*);
template <typename NP>
using Is_named_parameters = decltype(test_named_parameters(static_cast<const NP*>(nullptr)));
} // namespace internal
} // namespace Point_set_flow

template <typename ConcurrencyTag, typename PointRange,
          typename NamedParameters = parameters::Default_named_parameters>
double balanced_flow_smooth_point_set(PointRange& points, unsigned int k,
                                      const NamedParameters& np = parameters::default_values())
{
  return Point_set_flow::internal::smooth_point_set<ConcurrencyTag>(points, k, np);
}

template <typename ConcurrencyTag, typename PointRange,
          typename NamedParameters = parameters::Default_named_parameters,
          std::enable_if_t<Point_set_flow::internal::Is_named_parameters<NamedParameters>::value, int> = 0>
double balanced_flow_smooth_point_set(PointRange& points,
                                      const NamedParameters& np = parameters::default_values())
{
  return Point_set_flow::internal::smooth_point_set<ConcurrencyTag>(points, std::nullopt, np);
}

} // namespace CGAL

#endif // CGAL_BALANCED_FLOW_SMOOTH_POINT_SET_H
