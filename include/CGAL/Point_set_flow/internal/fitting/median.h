// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FITTING_MEDIAN_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FITTING_MEDIAN_H

#include <CGAL/license/Point_set_flow.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// The median; the upper one of an even number.
/// \param values not empty; are reordered
inline double median(std::vector<double>& values)
{
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FITTING_MEDIAN_H
