// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_file_io.h"

#include "Spool_file.h"
#include "invalid_points.h"

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <iostream>
#include <new>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace point_files {

namespace {

bool is_standard_stream(const std::filesystem::path& path) { return path == "-"; }

/// Opens a file to read all of it.
/// \return how long it is, as far as this is known
std::size_t open(std::ifstream& file, const std::filesystem::path& path)
{
  if (std::filesystem::is_directory(path))
    throw std::runtime_error("this is a directory");
  file.open(path, std::ios::binary);
  if (!file)
    throw std::runtime_error("the file can not be opened");
  std::error_code ignored; // pipes have no size
  return std::filesystem::is_regular_file(path)
             ? std::size_t(std::filesystem::file_size(path, ignored))
             : 0;
}

/// Reads all bytes; a file that is known to be large is not read twice as large.
/// \param bytes the first ones, which are read already
std::string read_bytes(std::istream& in, std::size_t size, std::string bytes)
{
  bytes.reserve(size + 1);
  for (std::size_t chunk = (std::max)(size + 1, std::size_t(1) << 20); in; chunk = bytes.size()) {
    const std::size_t before = bytes.size();
    bytes.resize(before + chunk);
    in.read(&bytes[before], std::streamsize(chunk));
    bytes.resize(before + std::size_t(in.gcount()));
  }
  if (in.bad())
    throw std::runtime_error("reading failed");
  bytes.shrink_to_fit();
  return bytes;
}

/// Reads from a stream. Who need not have all of the bytes in memory reads a copy on the disk.
std::unique_ptr<Point_file> read_stream(std::istream& in, std::size_t size, const Format* format,
                                        const Read_options& options)
{
  std::string start(1024, '\0');
  in.read(start.data(), std::streamsize(start.size()));
  start.resize(std::size_t(in.gcount()));
  const Format* const known = format ? format : format_with_magic(start);
  if (!known || !known->read_path)
    return read_point_bytes(read_bytes(in, size, std::move(start)), format, options);
  check_use(*known, options);
  const Spool_file copy;
  std::ofstream out(copy.path(), std::ios::binary);
  out << start;
  if (in.peek() != std::istream::traits_type::eof())
    out << in.rdbuf();
  if (!out.flush())
    throw std::runtime_error("writing to " + copy.path().string() + " failed");
  std::unique_ptr<Point_file> file = known->read_path(copy.path(), options);
  if (!file->format)
    file->format = known;
  find_invalid_points(*file, options);
  return file;
}

} // namespace

void check_use(const Format& format, const Read_options& options)
{
  check_support(format);
  if (!options.columns.empty() && !format.has_columns)
    throw std::runtime_error("--columns is for text, but the format is " + format.name);
}

std::unique_ptr<Point_file> read_point_bytes(Bytes bytes, const Format* format,
                                             const Read_options& options)
{
  refuse_wide_characters(bytes);
  if (!format)
    format = &format_of_bytes(bytes);
  check_use(*format, options);
  std::unique_ptr<Point_file> file = format->read(std::move(bytes), options);
  if (!file->format)
    file->format = format;
  find_invalid_points(*file, options);
  return file;
}

std::unique_ptr<Point_file> read_point_file(const std::filesystem::path& path, const Format* format,
                                            const Read_options& options)
{
  const bool from_stream = is_standard_stream(path);
  try {
    if (!format && !from_stream)
      format = &format_of(path);
    if (format)
      check_use(*format, options);
    if (from_stream)
      return read_stream(std::cin, 0, format, options);
    if (!format->read_path || !std::filesystem::is_regular_file(path)) {
      std::ifstream stream;
      const std::size_t size = open(stream, path);
      return read_stream(stream, size, format, options);
    }
    std::unique_ptr<Point_file> file = format->read_path(path, options);
    if (!file->format)
      file->format = format;
    find_invalid_points(*file, options);
    return file;
  }
  catch (const std::bad_alloc&) {
    throw std::runtime_error("cannot read " + path.string() + ": not enough memory");
  }
  catch (const std::exception& e) {
    throw std::runtime_error("cannot read " + (from_stream ? "standard input" : path.string()) +
                             ": " + e.what());
  }
}

void request_normals(Point_file& file, const Format& format)
{
  if (format.adds_normals || !are_of_one_family(*file.format, format))
    file.add_normals();
  else
    file.warnings.push_back("normals can not be added to a file of the format " + format.name);
}

void warn_of_losses(Point_file& file, const Format& format)
{
  if (are_of_one_family(*file.format, format))
    return;
  if (!file.invalid.empty() && !file.drops_invalid)
    file.warnings.push_back(std::to_string(file.invalid.size()) + " invalid points are in the " +
                            format.name + ", too: --invalid drop leaves them out");
  for (const std::string& loss : file.losses())
    file.warnings.push_back(loss + " can not be kept in the format " + format.name);
  if (!file.columns().empty() && !format.columns_warning.empty())
    file.warnings.push_back(format.columns_warning);
}

void write_as(const Point_file& file, const Target& target)
{
  if (are_of_one_family(*file.format, target.format))
    file.write(target);
  else
    target.format.write(target, file);
  if (!target.out.flush())
    throw std::runtime_error("writing failed");
}

} // namespace point_files
