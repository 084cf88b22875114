// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_BLOCKS_INPUT_ORDER_H
#define BALANCED_FLOW_BLOCKS_INPUT_ORDER_H

#include "Disk_file.h"
#include "Manifest.h"
#include "Progress.h"
#include "point_files/Streamed_file.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace balanced_flow_blocks {

/// The results in the order of the inputs: a file in which each point has its place, without its number. NaN stands for
/// points that stay as they are.
class Input_order {
  const Manifest& m_manifest;
  std::filesystem::path m_path;

public:
  /// Puts the results into this order.
  Input_order(const Manifest& manifest, const Progress& progress);
  ~Input_order();
  Input_order(const Input_order&) = delete;
  Input_order& operator=(const Input_order&) = delete;

  /// The new points of one of the inputs
  class Points : public point_files::New_points {
    const Disk_file m_file;
    const Manifest& m_manifest;
    const std::uint64_t m_first;
    const Progress& m_progress;

  public:
    Points(const Input_order& order, const Input_file& input, const Progress& progress);
    void replace(std::uint64_t first, point_files::Chunk_of_points& chunk) const override;
  };

private:
  std::vector<std::filesystem::path> distribute(std::uint64_t part_size,
                                                const Progress& progress) const;
};

} // namespace balanced_flow_blocks

#endif // BALANCED_FLOW_BLOCKS_INPUT_ORDER_H
