// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_BLOCKS_MANIFEST_H
#define BALANCED_FLOW_BLOCKS_MANIFEST_H

#include "Page.h"
#include "command_line/Settings.h"

#include <CGAL/Point_set_flow/Coordinate_frame.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace balanced_flow_blocks {

using balanced_flow_smooth::Settings;
using balanced_flow_smooth::Smoothing_settings;

/// A file that is smoothed
struct Input_file {
  std::filesystem::path path, output; // output: where `join` writes it
  std::string format;
  std::uint64_t size = 0;
  std::int64_t time = 0;              // of the last change
  std::uint64_t first = 0, count = 0; // the numbers of its points
  std::uint64_t invalid = 0;          // how many of them are none

  /// Reads size and time.
  void look_at_file();
  /// Throws `std::runtime_error` if somebody has written to the file since it was read.
  void check_unchanged() const;
};

/// Points that are smoothed at a time
struct Block {
  std::uint64_t count = 0;
  std::uint32_t first_page = 0, page_count = 0;
};

/// What is known of a working directory: all that `plan` found and decided
struct Manifest {
  std::filesystem::path directory;
  Settings settings;            // those of the command `plan`; no jobs
  std::uint64_t memory = 0;     // in bytes, of one process
  std::uint64_t block_size = 0; // the largest number of points in a block
  bool has_normals = false; // whether points have a vector to the side on which they were measured
  bool writes_normals = false;        // whether normals are a result
  std::uint64_t number_of_points = 0; // in all inputs, also those that are none
  CGAL::Point_set_flow::Coordinate_frame frame;
  std::vector<Input_file> inputs;
  std::vector<std::uint64_t>
      scans; // the number of the first point of each; empty if all are of one
  std::optional<std::uint64_t> sided_points; // whose side the scanner tells; empty if there is none
  std::vector<Block> blocks;
  std::vector<Page> pages;    // in the order of the blocks
  std::uint64_t checksum = 0; // of the manifest itself

  /// \pre there are scans
  std::uint32_t scan_of(std::uint64_t number) const
  {
    return std::uint32_t(std::upper_bound(scans.begin(), scans.end(), number) - scans.begin() - 1);
  }

  static bool exists(const std::filesystem::path& directory);
  /// Throws `std::runtime_error` if there is none, or if it is damaged.
  static Manifest read(const std::filesystem::path& directory);
  /// The last thing that `plan` does
  void write();

  std::filesystem::path points_file(std::size_t block) const;
  std::filesystem::path result_file(std::size_t block) const;
};

} // namespace balanced_flow_blocks

#endif // BALANCED_FLOW_BLOCKS_MANIFEST_H
