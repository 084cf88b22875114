// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_BLOCKS_COPYING_H
#define BALANCED_FLOW_BLOCKS_COPYING_H

#include "Frame_search.h"
#include "Manifest.h"
#include "Progress.h"
#include "Record_stream.h"
#include "point_files/Streamed_file.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace balanced_flow_blocks {

/// Copies points of the inputs to one file, sorts them into blocks, and writes the manifest.
class Copying {
  Manifest& m_manifest;
  const std::filesystem::path m_copy;
  Record_writer m_out;
  Frame_search m_frame;
  Records m_records;
  std::uint64_t m_count = 0;

public:
  /// Which points of a file
  struct Range {
    std::uint64_t begin, end;
  };
  /// Tells the normals of a chunk, which begins with a point of that number in the file; they may be empty.
  typedef std::function<std::vector<point_files::Vector_3>(const point_files::Chunk_of_points&,
                                                           std::uint64_t)>
      Normals;

  explicit Copying(Manifest& manifest);

  /// \param input learns how many points are invalid
  void copy(Input_file& input, const point_files::Streamed_file& file, const Range& range,
            const Normals& normals, const Progress& progress);

  /// Sorts what was copied. Throws `std::runtime_error` if there is nothing.
  void sort(const Progress& progress);

private:
  bool is_valid(const point_files::Point_3& p, std::uint64_t i,
                const point_files::Streamed_file& file, Input_file& input) const;
};

} // namespace balanced_flow_blocks

#endif // BALANCED_FLOW_BLOCKS_COPYING_H
