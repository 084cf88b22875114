// SPDX-License-Identifier: GPL-3.0-or-later
#include "Streamed_file.h"

#include "point_file_io.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace point_files {

namespace {

/// A file of a format that can not be streamed: all of it is in memory.
class Whole_file : public Streamed_file {
  std::unique_ptr<Point_file> m_file;

public:
  explicit Whole_file(std::unique_ptr<Point_file> file) : m_file(std::move(file))
  {
    format = m_file->format;
    count = m_file->points.size();
    has_normals = !m_file->normals.empty();
    defines_invalid = m_file->defines_invalid;
    zeros_are_invalid = m_file->zeros_are_invalid;
    warnings = m_file->warnings;
  }

  void for_each_chunk(const Visitor& visit) const override
  {
    visit({m_file->points, m_file->normals});
  }

  void write(const Target& target, const New_points& points) const override
  {
    Chunk_of_points all = {std::move(m_file->points), std::move(m_file->normals)};
    points.replace(0, all);
    m_file->points = std::move(all.points);
    m_file->normals = std::move(all.normals);
    write_as(*m_file, target);
  }
};

} // namespace

std::unique_ptr<Streamed_file> open_streamed_file(const std::filesystem::path& path,
                                                  const Format* format, const Read_options& options)
{
  try {
    if (!format)
      format = &format_of(path);
    check_support(*format);
    if (!options.columns.empty() && !format->has_columns)
      throw std::runtime_error("--columns is for text, but the format is " + format->name);
    if (!std::filesystem::is_regular_file(path))
      throw std::runtime_error(std::filesystem::exists(path) ? "this is not a regular file"
                                                             : "the file can not be opened");
    if (format->stream)
      if (std::unique_ptr<Streamed_file> file = format->stream(path)) {
        if (!file->format)
          file->format = format;
        if (file->count == 0)
          throw std::runtime_error("there are no points in it");
        return file;
      }
  }
  catch (const std::exception& e) {
    throw std::runtime_error("cannot read " + path.string() + ": " + e.what());
  }
  Read_options keeps = options; // what becomes of invalid points is decided elsewhere
  keeps.invalid = Invalid::KEEP;
  std::unique_ptr<Point_file> file = read_point_file(path, format, keeps);
  if (!file->sides.empty() || !file->scans.empty())
    throw std::runtime_error("cannot read " + path.string() +
                             ": it tells scans or positions of scanners, which are not used block by "
                             "block; it can be smoothed without a bound of memory only");
  return std::make_unique<Whole_file>(std::move(file));
}

} // namespace point_files
