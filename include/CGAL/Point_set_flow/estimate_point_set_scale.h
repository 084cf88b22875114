// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_ESTIMATE_POINT_SET_SCALE_H
#define CGAL_POINT_SET_FLOW_ESTIMATE_POINT_SET_SCALE_H

#include <CGAL/Point_set_flow/Point_set_scale.h>
#include <CGAL/Point_set_flow/Tangent_plane_curvature.h>
#include <CGAL/Point_set_flow/internal/order/Point_buffer.h>
#include <CGAL/Point_set_flow/internal/entrance/copy_in.h>
#include <CGAL/Point_set_flow/internal/noise/Scale_samples.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <functional>
#include <vector>

namespace CGAL {
namespace Point_set_flow {

/**
   \ingroup PkgPointSetFlowFunctions

   estimates the noise and the spacing of a point set, and with them the number of neighbors that
   suits the default estimator of `balanced_flow_smooth_point_set()`.

   The noise is the median deviation of about 1,000 neighborhoods from fitted quadrics. Of the
   neighborhood sizes 12, 24, 48, 96 and 192 it takes the first whose radius is at least four
   times the noise found with it: smaller ones can not tell noise from structure.

   \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`
   \tparam PointRange is a model of `Range` with forward iterators. The value type of its iterator
   is the key type of the named parameter `point_map`.

   \param points input point range
   \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `point_map` and
   `geom_traits`, with the same meaning as for `balanced_flow_smooth_point_set()`

   \return the estimates; noise and spacing are 0 where there are less than 13 distinct points

   \throws std::invalid_argument if a coordinate is not finite

   Complexity: that of sorting the points.
*/
template <typename ConcurrencyTag, typename PointRange,
          typename NamedParameters = parameters::Default_named_parameters>
Point_set_scale estimate_point_set_scale(const PointRange& points,
                                         const NamedParameters& np = parameters::default_values())
{
  typedef Point_set_processing_3_np_helper<PointRange, NamedParameters> NP_helper;
  internal::Array<Point_3> copy = internal::copy_in<typename NP_helper::Geom_traits::Point_3>(
      points, NP_helper::get_const_point_map(points, np), "points");
  if (copy.empty())
    return Point_set_scale();
  const std::function<bool(double)> no_callback;
  internal::Progress progress(no_callback, 1.);
  const internal::Frame frame = internal::find_frame(ConcurrencyTag(), copy, progress);
  internal::move_to_core(copy, frame);
  const internal::Point_buffer buffer(ConcurrencyTag(), copy, {}, {}, progress, 0.);
  const internal::Neighbor_tree tree(ConcurrencyTag(), buffer.reference, progress);
  const internal::Sampled_scale found = internal::find_scale(ConcurrencyTag(), tree, progress, 1.);
  const double ratio = found.spacing > 0. ? found.noise / found.spacing : 0.;
  Point_set_scale scale;
  scale.noise = found.noise * frame.unit;
  scale.spacing = found.spacing * frame.unit;
  scale.k = internal::neighborhood_size(Tangent_plane_curvature::defaults(), ratio);
  return scale;
}

} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_ESTIMATE_POINT_SET_SCALE_H
