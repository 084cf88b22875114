// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_FILES_POINT_FILE_IO_H
#define POINT_FILES_POINT_FILE_IO_H

#include "Format.h"
#include "Point_file.h"

#include <filesystem>
#include <memory>
#include <string>

// From files to points and back. The path "-" is standard input or output.

namespace point_files {

/// Throws `std::runtime_error` if a format can not be read, or not in this way.
void check_use(const Format& format, const Read_options& options);

/// Reads a point set; throws `std::runtime_error` with the reason if it can not.
/// \param format if it is null, it is found from the name, and for standard input from the bytes
std::unique_ptr<Point_file> read_point_file(const std::filesystem::path& path, const Format* format,
                                            const Read_options& options);

/// The same from all bytes of a file.
/// \param format if it is null, it is found from the bytes
std::unique_ptr<Point_file> read_point_bytes(Bytes bytes, const Format* format,
                                             const Read_options& options);

/// Makes room for normals in a file that has none; adds a warning instead if it can not get them.
/// \param format of the output
void request_normals(Point_file& file, const Format& format);

/// Adds to the warnings of the file what is lost on the way to another format.
void warn_of_losses(Point_file& file, const Format& format);

/// Writes a point set as a file of the format of the target.
void write_as(const Point_file& file, const Target& target);

} // namespace point_files

#endif // POINT_FILES_POINT_FILE_IO_H
