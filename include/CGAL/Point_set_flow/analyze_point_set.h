// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_ANALYZE_POINT_SET_H
#define CGAL_POINT_SET_FLOW_ANALYZE_POINT_SET_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/analyze_point_set.h>

#include <optional>
#include <type_traits>

namespace CGAL {
namespace Point_set_flow {

/**
   \ingroup PkgPointSetFlowFunctions

   analyzes a point set as `balanced_flow_smooth_point_set()` does, and reports what that function
   would find and use, without moving any point. Noise, spacing, numbers of neighbors and \f$K\f$ are
   found around each point; the report contains medians, and the smallest and the largest number of
   neighbors.

   \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`
   \tparam PointRange is a model of `Range` with forward iterators. The value type of its iterator
   is the key type of the named parameter `point_map`.

   \param points input point range; may be empty
   \param k number of neighbors of each point, at least 2
   \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": all of
   `balanced_flow_smooth_point_set()`, with the same meaning, `noise`, `normal_map` and `scan_map` among
   them. Nothing is written: the maps of points and normals need only be readable.

   \return the report; its movements, and the numbers of points that moved or did not, are 0. If the
   callback cancels, all its counts are 0, and its noise and its spacing are `NaN`.

   \throws std::invalid_argument if a coordinate is not finite or a parameter is out of its range
   \throws std::length_error if there are more than \f$2^{32}-1\f$ points

   Complexity: \f$O(n \log n)\f$, that of sorting the points and of searching neighbors.
*/
template <typename ConcurrencyTag, typename PointRange,
          typename NamedParameters = parameters::Default_named_parameters>
Smoothing_report analyze_point_set(const PointRange& points, unsigned int k,
                                   const NamedParameters& np = parameters::default_values())
{
  return internal::analyze_point_set<ConcurrencyTag>(
      points, std::optional<unsigned int>(k), np,
      internal::Argument_check("CGAL::Point_set_flow::analyze_point_set"));
}

/**
   \ingroup PkgPointSetFlowFunctions

   analyzes a point set as above, with numbers of neighbors that are chosen from the data.
*/
template <typename ConcurrencyTag, typename PointRange,
          typename NamedParameters = parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          ,
          std::enable_if_t<internal::Is_named_parameters<NamedParameters>::value, int> = 0
#endif
          >
Smoothing_report analyze_point_set(const PointRange& points,
                                   const NamedParameters& np = parameters::default_values())
{
  return internal::analyze_point_set<ConcurrencyTag>(
      points, std::optional<unsigned int>(), np,
      internal::Argument_check("CGAL::Point_set_flow::analyze_point_set"));
}

} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_ANALYZE_POINT_SET_H
