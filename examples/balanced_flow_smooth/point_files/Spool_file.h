// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_FILES_SPOOL_FILE_H
#define POINT_FILES_SPOOL_FILE_H

#include <filesystem>

namespace point_files {

/// A file for the time of a scope, where bytes come or go in one stream but are needed in any order.
/// It lies in the directory for temporary files (TMPDIR).
class Spool_file {
  std::filesystem::path m_path;

public:
  /// Throws `std::runtime_error` if there can be none.
  Spool_file();
  ~Spool_file();
  Spool_file(const Spool_file&) = delete;
  Spool_file& operator=(const Spool_file&) = delete;

  const std::filesystem::path& path() const { return m_path; }
};

} // namespace point_files

#endif // POINT_FILES_SPOOL_FILE_H
