// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_ESTIMATE_POINT_SET_NOISE_H
#define CGAL_ESTIMATE_POINT_SET_NOISE_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/estimate_point_set_scale.h>

namespace CGAL {

/**
   \ingroup PkgPointSetFlowFunctions

   estimates the standard deviation of the noise of a point set: of the distances of the points to
   the surface that they were measured on.

   The noise is estimated around one point of about 18, from quadrics fitted to its neighborhoods by
   least squares, and the median of these estimates is returned; see
   `Point_set_flow::estimate_point_set_scale()`, which finds the spacing as well. For Gaussian noise
   between 0.03 and 2 spacings on a smooth surface the estimate is within 15% of the truth. Surface detail
   below the sampling density counts as noise where it covers most of the surface. Smoothing uses the
   estimates around each point, not their median.

   \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`
   \tparam PointRange is a model of `Range` with forward iterators. The value type of its iterator
   is the key type of the named parameter `point_map`.

   \param points input point range
   \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `point_map` and
   `geom_traits`, with the same meaning as for `balanced_flow_smooth_point_set()`

   \return the standard deviation in the unit of the data; 0 if there are fewer than 13 distinct
   points

   \throws std::invalid_argument if a coordinate is not finite
   \throws std::length_error if there are more than \f$2^{32}-1\f$ points

   Complexity: \f$O(n \log n)\f$, that of sorting the points and of searching neighbors.

   \sa `balanced_flow_smooth_point_set()`
*/
template <typename ConcurrencyTag, typename PointRange,
          typename NamedParameters = parameters::Default_named_parameters>
double estimate_point_set_noise(const PointRange& points,
                                const NamedParameters& np = parameters::default_values())
{
  return Point_set_flow::internal::estimate_scale<ConcurrencyTag>(
             points, np, Point_set_flow::internal::Argument_check("CGAL::estimate_point_set_noise"))
      .noise;
}

} // namespace CGAL

#endif // CGAL_ESTIMATE_POINT_SET_NOISE_H
