// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_SMOOTH_SCENE_H
#define BALANCED_FLOW_SMOOTH_SCENE_H

#include "Cloud.h"
#include "Report.h"
#include "point_files/invalid_points.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace balanced_flow_smooth {

typedef std::vector<std::unique_ptr<point_files::Point_file>> Point_files;

/// Files as one cloud: a single file, or several that are scans of one scene
class Scene {
  const Point_files& m_files;
  std::vector<point_files::Set_aside> m_invalid;

public:
  Cloud cloud;

  /// Takes the points out of a single file, and copies those of several.
  explicit Scene(const Point_files& files);

  /// Gives points and normals back to the files, and counts what moved in each of several. Normals that are
  /// not known, null vectors and those that are not finite, stay unless `s.fills_normals`; without a step
  /// all that are known stay.
  void give_back(const Smoothing_settings& s, std::vector<File_report>& reports);

private:
  bool is_single() const { return m_files.size() == 1; }
  void swap_with(point_files::Point_file& file);
  void add(point_files::Point_file& file, bool has_normals, bool has_views);
  void give_back_normals(point_files::Point_file& file, std::size_t first,
                         const Smoothing_settings& s) const;
  Movement move_points(point_files::Point_file& file, std::size_t first) const;
};

/// Adds a warning to files that lie apart from all others.
void warn_of_distant_files(const Point_files& files);

} // namespace balanced_flow_smooth

#endif // BALANCED_FLOW_SMOOTH_SCENE_H
