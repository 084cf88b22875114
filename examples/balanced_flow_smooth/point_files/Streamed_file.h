// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_FILES_STREAMED_FILE_H
#define POINT_FILES_STREAMED_FILE_H

#include "Point_file.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace point_files {

/// Some points that follow each other in a file
struct Chunk_of_points {
  std::vector<Point_3> points;
  std::vector<Vector_3> normals; ///< empty if there are none
  std::vector<Vector_3>
      views; ///< vectors to the scanner, see `Point_file::sides`; empty if there are none
};

/// Where the new points of a file come from
class New_points {
public:
  virtual ~New_points() = default;
  /// Replaces points, and normals if there are any, by the new ones. Those that stay as they are are left.
  /// \param first the number of the first of them in the file
  virtual void replace(std::uint64_t first, Chunk_of_points& chunk) const = 0;
};

/// A file whose points need not be in memory at once
class Streamed_file {
public:
  std::filesystem::path path;
  const Format* format = nullptr;
  std::uint64_t count = 0; ///< of points
  bool has_normals = false, has_views = false;
  std::vector<std::uint64_t> scans = {0}; ///< the number of the first point of each
  bool defines_invalid = false, zeros_are_invalid = false; ///< see `Point_file`
  std::vector<std::string> warnings;

  virtual ~Streamed_file() = default;

  typedef std::function<void(const Chunk_of_points&)> Visitor;
  /// Goes through the points, chunk by chunk.
  virtual void for_each_chunk(const Visitor& visit) const = 0;

  /// Writes the file with new points; nothing else changes, see `Point_file::write()`.
  virtual void write(const Target& target, const New_points& points) const = 0;

protected:
  /// Calls a function that reads, and adds the name of the file to what goes wrong.
  template <typename Read>
  auto try_to_read(const Read& read) const
  {
    try {
      return read();
    }
    catch (const std::exception& e) {
      throw std::runtime_error("cannot read " + path.string() + ": " + e.what());
    }
  }
};

/// Opens a file without reading its points, if its format is one that allows it; else reads all of it. Throws
/// `std::runtime_error` if it can not.
/// \param format null if its name tells it
std::unique_ptr<Streamed_file> open_streamed_file(const std::filesystem::path& path,
                                                  const Format* format,
                                                  const Read_options& options);

constexpr std::size_t points_in_chunk = std::size_t(1) << 16;

} // namespace point_files

#endif // POINT_FILES_STREAMED_FILE_H
