// SPDX-License-Identifier: GPL-3.0-or-later
#include "Streamed_file.h"

#include "point_file_io.h"

#include <stdexcept>
#include <utility>

namespace point_files {

namespace {

/// A file of a format that can not be streamed: it is read as a whole whenever it is needed.
class Whole_file : public Streamed_file {
  const Format* m_format;
  Read_options m_options;

public:
  Whole_file(const std::filesystem::path& file_path, const Format* of_file,
             const Read_options& options)
      : m_format(of_file), m_options(options)
  {
    path = file_path;
    m_options.invalid = Invalid::KEEP; // what becomes of invalid points is decided elsewhere
    const std::unique_ptr<Point_file> file = read();
    format = file->format;
    count = file->points.size();
    has_normals = !file->normals.empty();
    has_views = !file->sides.empty();
    defines_invalid = file->defines_invalid;
    zeros_are_invalid = file->zeros_are_invalid;
    warnings = file->warnings;
    for (std::size_t i = 1; i < file->scans.size(); ++i)
      if (file->scans[i] != file->scans[i - 1])
        scans.push_back(i);
  }

  void for_each_chunk(const Visitor& visit) const override
  {
    const std::unique_ptr<Point_file> file = read();
    visit({std::move(file->points), std::move(file->normals), std::move(file->sides)});
  }

  void write(const Target& target, const New_points& points) const override
  {
    const std::unique_ptr<Point_file> file = read();
    Chunk_of_points all = {std::move(file->points), std::move(file->normals), {}};
    points.replace(0, all);
    file->points = std::move(all.points);
    file->normals = std::move(all.normals);
    write_as(*file, target);
  }

private:
  std::unique_ptr<Point_file> read() const { return read_point_file(path, m_format, m_options); }
};

} // namespace

std::unique_ptr<Streamed_file> open_streamed_file(const std::filesystem::path& path,
                                                  const Format* format, const Read_options& options)
{
  try {
    if (!format)
      format = &format_of(path);
    check_use(*format, options);
    if (!std::filesystem::is_regular_file(path))
      throw std::runtime_error(std::filesystem::exists(path) ? "this is not a regular file"
                                                             : "the file can not be opened");
    if (format->stream)
      if (std::unique_ptr<Streamed_file> file = format->stream(path, options)) {
        if (!file->format)
          file->format = format;
        file->path = path;
        if (file->count == 0)
          throw std::runtime_error("there are no points in it");
        return file;
      }
  }
  catch (const std::exception& e) {
    throw std::runtime_error("cannot read " + path.string() + ": " + e.what());
  }
  return std::make_unique<Whole_file>(path, format, options);
}

} // namespace point_files
