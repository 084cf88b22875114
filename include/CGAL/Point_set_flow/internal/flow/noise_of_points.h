// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FLOW_NOISE_OF_POINTS_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FLOW_NOISE_OF_POINTS_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/neighbors/Surface.h>
#include <CGAL/Point_set_flow/internal/order/Given_noise.h>

#include <cstddef>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// The noise around each point, in spacings: what the caller gave, or else that of its part.
inline Array<float> noise_of_points(const Given_noise& given, const Surface_state& state)
{
  Array<float> noise(state.part_of.size());
  for (std::size_t i = 0; i < noise.size(); ++i) {
    const Local_parameters& part = state.parameters(i);
    noise[i] = in_spacings(given.of(i).value_or(part.noise), part.spacing);
  }
  return noise;
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FLOW_NOISE_OF_POINTS_H
