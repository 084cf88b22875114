// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_BLOCKS_BLOCK_WRITER_H
#define BALANCED_FLOW_BLOCKS_BLOCK_WRITER_H

#include "Disk_file.h"
#include "Manifest.h"
#include "Progress.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>

namespace balanced_flow_blocks {

/// Sorts points into blocks and pages, by halving boxes along their longest side: a file of points that does not
/// fit into memory is first distributed to smaller files.
class Block_writer {
  Manifest& m_manifest;
  const Progress m_progress;
  const std::size_t m_capacity; // points in memory
  const std::size_t m_block_size;
  std::uint64_t m_done = 0, m_total;
  std::size_t m_file_count = 0; // of those with points to be sorted

public:
  /// \param manifest receives blocks and pages
  /// \param total the number of points
  Block_writer(Manifest& manifest, std::uint64_t total, const Progress& progress);

  /// Sorts the points of a file, which is removed.
  void sort(const std::filesystem::path& file);

private:
  void distribute(const std::filesystem::path& file, std::uint64_t count);
  void sort_in_memory(const std::filesystem::path& file);
  void cut_blocks(const Records& records, std::uint32_t* first, std::uint32_t* last);
  void cut_pages(const Records& records, std::uint32_t* first, std::uint32_t* last,
                 Disk_file& file);
  static std::uint32_t* halve(const Records& records, std::uint32_t* first, std::uint32_t* last);
  void write_page(const Records& records, const std::uint32_t* first, const std::uint32_t* last,
                  Disk_file& file);
};

} // namespace balanced_flow_blocks

#endif // BALANCED_FLOW_BLOCKS_BLOCK_WRITER_H
