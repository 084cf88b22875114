// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_SMOOTH_POINT_FILE_IO_H
#define BALANCED_FLOW_SMOOTH_POINT_FILE_IO_H

#include "Format.h"
#include "Interrupt.h"
#include "Temporary_file.h"
#include "convert.h"
#include "read_ply.h"
#include "read_text.h"
#ifdef POINT_SET_FLOW_WITH_PDAL
#include "Las_file.h"
#endif

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

inline void check_support([[maybe_unused]] Format format)
{
#ifndef POINT_SET_FLOW_WITH_PDAL
  if (is_las(format))
    throw std::runtime_error("this program was built without LAS support (PDAL)");
#endif
}

/// Reads all bytes; a file that is known to be large is not read twice as large.
inline std::string read_bytes(const std::filesystem::path& path)
{
  std::ifstream file;
  std::size_t size = 0;
  if (!is_standard_stream(path)) {
    if (std::filesystem::is_directory(path))
      throw std::runtime_error("this is a directory");
    file.open(path, std::ios::binary);
    if (!file)
      throw std::runtime_error("the file can not be opened");
    std::error_code ignored; // pipes have no size
    if (std::filesystem::is_regular_file(path))
      size = std::size_t(std::filesystem::file_size(path, ignored));
  }
  std::istream& in = is_standard_stream(path) ? std::cin : file;
  std::string bytes;
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

/// \param format changed to what is found in the bytes if it is empty
inline std::unique_ptr<Point_file> read_point_bytes(std::string bytes,
                                                    std::optional<Format>& format,
                                                    [[maybe_unused]] bool with_normals)
{
  if (!format)
    format = format_of_bytes(bytes);
  check_support(*format);
  switch (*format) {
  case Format::PLY:
    return std::make_unique<Raw_file>(read_ply(std::move(bytes)));
  case Format::OFF:
    return std::make_unique<Raw_file>(read_off(std::move(bytes)));
#ifdef POINT_SET_FLOW_WITH_PDAL
  case Format::LAS:
  case Format::LAZ:
    return Las_file::of_bytes(bytes, with_normals);
#endif
  default:
    return std::make_unique<Raw_file>(read_xyz(std::move(bytes)));
  }
}

/// Reads a point set; throws `std::runtime_error` with the reason if it can not.
/// \param format if it is empty, it is found from the name, and for standard input from the bytes
/// \param with_normals whether normals are wanted that are not in the file
inline std::unique_ptr<Point_file> read_point_file(const std::filesystem::path& path,
                                                   std::optional<Format>& format, bool with_normals)
{
  const Nothing_at_stake nothing_at_stake;
  const bool from_stream = is_standard_stream(path);
  try {
    if (!format && !from_stream)
      format = format_of(path);
    if (format)
      check_support(*format);
#ifdef POINT_SET_FLOW_WITH_PDAL
    if (!from_stream && is_las(*format))
      return std::make_unique<Las_file>(path, with_normals);
#endif
    return read_point_bytes(read_bytes(path), format, with_normals);
  }
  catch (const std::bad_alloc&) {
    throw std::runtime_error("cannot read " + path.string() + ": not enough memory");
  }
  catch (const std::exception& e) {
    throw std::runtime_error("cannot read " + (from_stream ? "standard input" : path.string()) +
                             ": " + e.what());
  }
}

[[noreturn]] inline void fail_to_write(const std::filesystem::path& path, const std::string& why)
{
  throw std::runtime_error("cannot write " +
                           (is_standard_stream(path) ? "standard output" : path.string()) + ": " +
                           why);
}

/// Throws `std::runtime_error` if the output could not be written, before any work is done.
/// \param format if it is known before the input is read
inline void check_output(const std::filesystem::path& path, const std::optional<Format>& format)
{
  try {
    if (format)
      check_support(*format);
    if (is_standard_stream(path))
      return;
    if (std::filesystem::is_directory(path))
      throw std::runtime_error("this is a directory (--output-dir writes into one)");
    if (std::filesystem::exists(path) && !std::filesystem::is_regular_file(path))
      throw std::runtime_error("this is not a regular file");
    if (path.has_parent_path() && !std::filesystem::is_directory(path.parent_path()))
      throw std::runtime_error("there is no directory " + path.parent_path().string());
    const Temporary_file trial(path);
  }
  catch (const std::exception& e) {
    fail_to_write(path, e.what());
  }
}

/// Tells what is lost on the way to another format.
inline void warn_of_losses(Point_file& file, Format from, Format to)
{
  if (same_kind(from, to))
    return;
  for (const std::string& loss : file.losses())
    file.warnings.push_back(loss + " can not be kept in the format " + name_of(to));
  if (!file.columns().empty() && to == Format::OFF)
    file.warnings.push_back("OFF has no names for properties, they become columns");
}

inline void write_as(const Point_file& file, Format from, const Target& target)
{
  if (same_kind(from, target.format))
    file.write(target);
  else if (target.format == Format::PLY)
    write_as_ply(target.out, file);
  else if (target.format == Format::XYZ)
    write_as_xyz(target.out, file);
  else if (target.format == Format::OFF)
    write_as_off(target.out, file);
#ifdef POINT_SET_FLOW_WITH_PDAL
  else
    write_as_las(target, file);
#endif
  if (!target.out.flush())
    throw std::runtime_error("writing failed");
}

/// Writes a point set, first beside the file and then in its place: a run that fails or is killed
/// never leaves half a file. If it is interrupted by then, nothing is written.
/// \return whether the file is written
inline bool write_point_file(const std::filesystem::path& path, const Point_file& file, Format from,
                             Format to)
{
  try {
    if (is_standard_stream(path)) {
      write_as(file, from, {std::cout, "", to});
      return true;
    }
    Temporary_file out(path);
    write_as(file, from, {out.stream(), out.path(), to});
    if (interrupt != 0)
      return false;
    out.take_place();
    return true;
  }
  catch (const std::exception& e) {
    fail_to_write(path, e.what());
  }
}

#endif // BALANCED_FLOW_SMOOTH_POINT_FILE_IO_H
