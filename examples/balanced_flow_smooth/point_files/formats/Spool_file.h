// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_FILES_SPOOL_FILE_H
#define POINT_FILES_SPOOL_FILE_H

#include <filesystem>
#include <random>
#include <string>
#include <system_error>

namespace point_files {

/// A file for PDAL, which reads and writes files only and has an opinion about "#" in their names
class Spool_file {
  std::filesystem::path m_path;

public:
  Spool_file()
      : m_path(std::filesystem::temp_directory_path() /
               ("balanced-flow-smooth." + std::to_string(std::random_device()()) + ".las"))
  {}
  ~Spool_file()
  {
    std::error_code ignored;
    std::filesystem::remove(m_path, ignored);
  }
  Spool_file(const Spool_file&) = delete;
  Spool_file& operator=(const Spool_file&) = delete;

  const std::filesystem::path& path() const { return m_path; }

  static bool is_needed_for(const std::filesystem::path& path)
  {
    return path.empty() || path.string().find('#') != std::string::npos;
  }
};

} // namespace point_files

#endif // POINT_FILES_SPOOL_FILE_H
