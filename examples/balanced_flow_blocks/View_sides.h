// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_BLOCKS_VIEW_SIDES_H
#define BALANCED_FLOW_BLOCKS_VIEW_SIDES_H

#include "Input_order.h"
#include "Manifest.h"
#include "Progress.h"
#include "point_files/Streamed_file.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace balanced_flow_blocks {

/// The sides that the positions of scanners tell, see `balanced_flow_smooth::find_sides()`: the normals of each scan are
/// found in blocks, in a directory of their own within that of the plan.
class View_sides {
  class Scan_normals;
  const std::filesystem::path m_directory;
  std::vector<std::vector<std::unique_ptr<Scan_normals>>>
      m_normals; // for each file and scan, null if not needed
  std::optional<std::uint64_t> m_count;

public:
  typedef std::vector<std::unique_ptr<point_files::Streamed_file>> Streamed_files;

  /// \param manifest has settings and inputs
  View_sides(const Manifest& manifest, const Streamed_files& files, const Progress& progress);
  ~View_sides();
  View_sides(const View_sides&) = delete;
  View_sides& operator=(const View_sides&) = delete;

  /// Whether files have positions of scanners.
  bool are_any() const { return m_count.has_value(); }
  /// How many sides were told; nothing if there are no positions of scanners
  const std::optional<std::uint64_t>& count() const { return m_count; }

  /// The sides of the points of a chunk: their normals, or what the view tells
  /// \param first the number of the first point in the file
  std::vector<point_files::Vector_3>
  operator()(std::size_t file, const point_files::Chunk_of_points& chunk, std::uint64_t first);

  /// Removes the directory.
  void remove();

  static std::filesystem::path directory(const std::filesystem::path& of_plan)
  {
    return of_plan / "sides";
  }
};

} // namespace balanced_flow_blocks

#endif // BALANCED_FLOW_BLOCKS_VIEW_SIDES_H
