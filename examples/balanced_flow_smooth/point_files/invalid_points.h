// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_FILES_INVALID_POINTS_H
#define POINT_FILES_INVALID_POINTS_H

#include "Point_file.h"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace point_files {

// Points of a file that are none: where a scanner saw nothing, some formats keep a place.

/// Finds the invalid points of a file and decides what becomes of them. Throws `std::runtime_error` if
/// there are some but must not be, or if no other points are left.
void find_invalid_points(Point_file& file, const Read_options& options);

/// Takes the invalid points out of a file for as long as its points are smoothed.
class Set_aside {
  Point_file& m_file;
  std::vector<Point_3> m_points;
  std::vector<Vector_3> m_normals, m_sides;
  std::vector<std::uint32_t> m_scans;

public:
  explicit Set_aside(Point_file& file);
  /// Puts them back to their places.
  void put_back();
};

} // namespace point_files

#endif // POINT_FILES_INVALID_POINTS_H
