// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_FILES_LAS_OUTPUT_H
#define POINT_FILES_LAS_OUTPUT_H

#include "../../Point_file.h"
#include "Header.h"
#include "Input.h"
#include "Records.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace point_files::las {

/// Bytes of the input, from `begin` to `end`
struct Range {
  std::uint64_t begin, end;
};

/// A file without its points
struct Frame {
  std::string header; // as for the input: places and counts of records are set when it is written
  unsigned point_format = 0;
  std::size_t record_size = 0;
  std::uint64_t count = 0;
  const Input* input = nullptr; // of the ranges
  std::vector<Range> vlrs;      // in the order of the file, as those behind the points
  std::string new_vlrs;
  unsigned vlr_count = 0; // of both
  Range gap = {0, 0};     // between the records and the points
  std::vector<Range> rest;
  unsigned evlr_count = 0;

  Frame() = default;

  /// What stays of a file.
  /// \param recodes whether the points are compressed before or after: then the records do not stay
  /// that tell how, and those of COPC, which tell where
  Frame(const Input& input, const Header& header, bool recodes);

  bool has_evlrs() const { return evlr_count != 0; }
};

/// Calls the function with a writer of records, and writes what belongs around them.
void write_file(const Target& target, const Frame& frame,
                const std::function<void(Record_writer&)>& write_points);

} // namespace point_files::las

#endif // POINT_FILES_LAS_OUTPUT_H
