// SPDX-License-Identifier: GPL-3.0-or-later
#include "Point_file.h"

#include <new>
#include <stdexcept>

namespace point_files {

void Point_file::load(std::size_t count, bool with_normals)
{
  if (count > points.max_size())
    throw std::bad_alloc();
  points.reserve(count);
  normals.reserve(with_normals ? count : 0);
  for_each_record(false, [&](const Record& r) {
    const double *p = r.coordinates, *n = r.normal;
    points.emplace_back(p[0], p[1], p[2]);
    if (with_normals)
      normals.emplace_back(n[0], n[1], n[2]);
  });
  if (points.empty())
    throw std::runtime_error("there are no points in it");
}

} // namespace point_files
