// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_ESTIMATE_POINT_SET_SCALE_H
#define CGAL_POINT_SET_FLOW_ESTIMATE_POINT_SET_SCALE_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/Point_set_scale.h>
#include <CGAL/Point_set_flow/internal/estimate_scale.h>

namespace CGAL {
namespace Point_set_flow {

/**
   \ingroup PkgPointSetFlowFunctions

   estimates the noise and the spacing of a point set, and with them the number of neighbors that
   suits the default estimator of `balanced_flow_smooth_point_set()`.

   Noise and spacing are estimated around one point of about 18, and their medians are returned. Where both
   vary, these describe the point set, but `balanced_flow_smooth_point_set()` does not use them: it uses
   the estimates around each point. If the caller of that function gives normals, its estimates also leave
   out neighbors on the opposite side, and may be smaller.

   The noise is the deviation of neighborhoods from fitted quadrics, pooled over the 64 nearest of these
   points. Of the neighborhood sizes 12, 24, 48 and 96 the first is used whose neighborhoods spread
   over a surface rather than over lines or columns, and whose radius is at least 2.1 times the noise found
   with it: smaller ones cannot tell noise from shape. From the two smallest, the deviation is
   extrapolated to a neighborhood without shape.

   \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`
   \tparam PointRange is a model of `Range` with forward iterators. The value type of its iterator
   is the key type of the named parameter `point_map`.

   \param points input point range
   \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `point_map` and
   `geom_traits`, with the same meaning as for `balanced_flow_smooth_point_set()`

   \return the estimates; noise and spacing are 0 if there are fewer than 13 distinct points, and the
   noise is 0 if the neighborhoods do not spread over a surface

   \throws std::invalid_argument if a coordinate is not finite
   \throws std::length_error if there are more than \f$2^{32}-1\f$ points

   Complexity: \f$O(n \log n)\f$, that of sorting the points and of searching neighbors.
*/
template <typename ConcurrencyTag, typename PointRange,
          typename NamedParameters = parameters::Default_named_parameters>
Point_set_scale estimate_point_set_scale(const PointRange& points,
                                         const NamedParameters& np = parameters::default_values())
{
  return internal::estimate_scale<ConcurrencyTag>(
      points, np, internal::Argument_check("CGAL::Point_set_flow::estimate_point_set_scale"));
}

} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_ESTIMATE_POINT_SET_SCALE_H
