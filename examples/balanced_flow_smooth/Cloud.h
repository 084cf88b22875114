// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_SMOOTH_CLOUD_H
#define BALANCED_FLOW_SMOOTH_CLOUD_H

#include "point_files/Point_file.h"

#include <cstdint>
#include <vector>

namespace balanced_flow_smooth {

/// Points that are smoothed as one point set
struct Cloud {
  std::vector<point_files::Point_3> points;
  /// vectors to the sides on which the points were measured; null vectors where nothing tells them, and
  /// empty if nothing tells any
  std::vector<point_files::Vector_3> normals;
  /// vectors to the scanners, as the normals
  std::vector<point_files::Vector_3> views;
  /// the number of the scan of each point; empty if all are of one. The points of a scan stand together.
  std::vector<std::uint32_t> scans;
};

} // namespace balanced_flow_smooth

#endif // BALANCED_FLOW_SMOOTH_CLOUD_H
