// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_SMOOTH_BLOCK_H
#define CGAL_POINT_SET_FLOW_SMOOTH_BLOCK_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/Coordinate_frame.h>
#include <CGAL/Point_set_flow/internal/smooth_block.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <type_traits>

namespace CGAL {
namespace Point_set_flow {

/**
   \ingroup PkgPointSetFlowFunctions

   finds the frame in which `balanced_flow_smooth_point_set()` smooths a point set.

   \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`
   \param points input point range; may be empty
   \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `point_map` and
   `geom_traits`
   \throws std::invalid_argument if a coordinate is not finite
*/
template <typename ConcurrencyTag, typename PointRange,
          typename NamedParameters = parameters::Default_named_parameters>
Coordinate_frame find_coordinate_frame(const PointRange& points,
                                       const NamedParameters& np = parameters::default_values())
{
  const internal::Argument_check check("CGAL::Point_set_flow::find_coordinate_frame");
  const internal::Caller_maps<const PointRange, NamedParameters> maps(points, np, check);
  internal::Frame frame;
  if (points.begin() != points.end()) {
    internal::Loops<ConcurrencyTag> loops(std::function<bool(double)>(), 1.);
    loops.in_isolation([&] { internal::copy_reference(maps, frame, check, loops); });
  }
  return frame;
}

/**
   \ingroup PkgPointSetFlowFunctions

   denoises some points of a point set, of which the others need not all be at hand. The result is
   bitwise identical to that of `balanced_flow_smooth_point_set()` for all points; or nothing is written,
   since points are missing on which the result depends. So a point set can be smoothed that fits into
   no memory, or on several machines.

   The result depends on the points within some rings of neighbors around the block, about 50 to 100
   spacings by default, and those around which noise and spacing are found there. Where they are is known
   only when they are looked for: each search must end before a place where points may be missing.
   `halo` tells where these places are, and learns what is missing.

   \tparam ConcurrencyTag enables sequential versus parallel algorithm. Possible values are
   `Sequential_tag`, `Parallel_tag`, and `Parallel_if_available_tag`.
   \tparam PointRange is a model of `Range` with forward iterators. The value type of its iterator
   is the key type of the named parameter `point_map`.
   \tparam Halo is a model of `PointSetHalo`

   \param points input point range: first the points of the block, then others in any order. Of
   duplicates, all must be there.
   \param block_size the number of points of the block, which are written; the others are not
   \param frame that of all points, not only of those in the range
   \param halo knows which points are not in the range
   \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": those of
   `balanced_flow_smooth_point_set()`, with the same values for all blocks. For a `Point_set_3` the
   maps must be given, by `Point_set_3::parameters()`. `smoothing_report` receives the counts of the points of the
   block, and medians over all points of the range; the named parameter `block_size` is not used.

   \return whether the points are smoothed. If they are not, nothing is written.

   \throws std::invalid_argument, std::overflow_error, std::length_error as
   `balanced_flow_smooth_point_set()` does
*/
template <typename ConcurrencyTag, typename PointRange, typename Halo,
          typename NamedParameters = parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          ,
          std::enable_if_t<internal::Is_named_parameters<NamedParameters>::value, int> = 0
#endif
          >
Block_status smooth_block(PointRange& points, std::size_t block_size, const Coordinate_frame& frame,
                          Halo& halo, const NamedParameters& np = parameters::default_values())
{
  return internal::smooth_block<ConcurrencyTag>(points, block_size, frame, halo, std::nullopt, np);
}

/**
   \ingroup PkgPointSetFlowFunctions

   denoises a block as above, with a given number of neighbors.

   \param points, block_size, frame, halo, np as above
   \param k number of neighbors of each point, at least 2
*/
template <typename ConcurrencyTag, typename PointRange, typename Halo,
          typename NamedParameters = parameters::Default_named_parameters>
Block_status smooth_block(PointRange& points, std::size_t block_size, const Coordinate_frame& frame,
                          Halo& halo, unsigned int k,
                          const NamedParameters& np = parameters::default_values())
{
  return internal::smooth_block<ConcurrencyTag>(points, block_size, frame, halo,
                                                std::optional<unsigned int>(k), np);
}

} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_SMOOTH_BLOCK_H
