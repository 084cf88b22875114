// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_BLOCK_STATUS_H
#define CGAL_POINT_SET_FLOW_BLOCK_STATUS_H

#include <CGAL/license/Point_set_flow.h>

namespace CGAL {
namespace Point_set_flow {

/// \ingroup PkgPointSetFlowFunctions
/// What became of a block, see `smooth_block()`
enum class Block_status {
  SMOOTHED,       ///< the points of the block are written
  HALO_TOO_SMALL, ///< the result would depend on points that are not there; nothing is written
  CANCELED        ///< the callback said no; nothing is written
};

} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_BLOCK_STATUS_H
