// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_FILES_WRITE_POINT_FILES_H
#define POINT_FILES_WRITE_POINT_FILES_H

#include "Format.h"
#include "Point_file.h"

#include <filesystem>
#include <functional>
#include <vector>

namespace point_files {

/// Throws `std::runtime_error` if the output could not be written, before any work is done.
/// \param path "-" for standard output
/// \param format null if it is not known before the input is read
void check_output(const std::filesystem::path& path, const Format* format);

/// A point set to be written
struct Output {
  std::filesystem::path path; ///< "-" for standard output
  const Point_file& file;
  const Format& format;
};

/// Writes point sets, first beside the files and then in their places: a run that fails never
/// leaves half a file, nor replaces only some of them. Throws `std::runtime_error` if it fails.
/// \param is_interrupted asked when all but the places is done: if it says so, nothing is written
/// \return whether the files are written
bool write_point_files(const std::vector<Output>& outputs,
                       const std::function<bool()>& is_interrupted);

} // namespace point_files

#endif // POINT_FILES_WRITE_POINT_FILES_H
