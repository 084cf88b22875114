// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_FILES_LAS_HEADER_H
#define POINT_FILES_LAS_HEADER_H

#include "Input.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace point_files::las {

/// Where things are in the header, in bytes
namespace at {
constexpr std::size_t global_encoding = 6, version = 24, header_size = 94, points = 96,
                      vlr_count = 100, point_format = 104, record_size = 105, legacy_count = 107,
                      legacy_counts_by_return = 111, scale = 131, offset = 155,
                      bounds = 179, // max x, min x, max y, ...
    waveforms = 227, evlrs = 235, evlr_count = 243, count = 247, counts_by_return = 255;
} // namespace at

/// A variable length record, or an extended one, behind the points
struct Variable_record {
  std::string user_id;
  unsigned id;
  std::uint64_t begin, data, end; // in the file

  bool is(const char* other_user_id, unsigned other_id) const
  {
    return user_id == other_user_id && id == other_id;
  }
};

/// From the integers of the records to coordinates and back
struct Grid {
  std::array<double, 3> scale, offset;

  double coordinate(std::int32_t integer, std::size_t axis) const
  {
    return integer * scale[axis] + offset[axis];
  }

  /// The nearest integer; throws `std::runtime_error` if it is none of 32 bits.
  /// \param point its index, for the message
  std::int32_t integer(double coordinate, std::size_t axis, std::size_t point) const;
};

/// What the header of a file says, checked against the size of the file and against itself
struct Header {
  std::string bytes; // of the header itself
  unsigned minor_version = 0;
  std::uint64_t points_begin = 0;
  std::uint64_t points_end = 0; // 0 if they are compressed
  std::uint64_t count = 0;
  unsigned point_format = 0;
  bool is_compressed = false;
  std::size_t record_size = 0;
  Grid grid = {};
  std::uint64_t vlrs_end = 0;
  std::vector<Variable_record> vlrs, evlrs;
  std::uint64_t evlrs_begin = 0;     // 0 if there are none
  std::uint64_t waveforms_begin = 0; // 0 if they are not in the file

  /// Throws `std::runtime_error` if something does not hold together.
  explicit Header(const Input& input);

  /// where that begins which comes behind the points; the size of the file if nothing does
  std::uint64_t rest_begin(const Input& input) const;

  /// The record of that name, or null
  const Variable_record* find(const char* user_id, unsigned id) const;

  bool is_copc() const { return find("copc", 1) != nullptr; }

private:
  void read_size(const Input& input);
  void read_points(const Input& input);
  void read_count();
  void read_vlrs(const Input& input);
  void read_evlrs(const Input& input);
};

/// The bytes of a record of a point format, without extra ones
std::size_t smallest_record(unsigned point_format);

} // namespace point_files::las

#endif // POINT_FILES_LAS_HEADER_H
