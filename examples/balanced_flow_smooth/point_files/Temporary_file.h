// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_FILES_TEMPORARY_FILE_H
#define POINT_FILES_TEMPORARY_FILE_H

#include <filesystem>
#include <fstream>
#include <ostream>

namespace point_files {

/// A new file beside the one to be written; removed unless it takes that one's place.
class Temporary_file {
  std::filesystem::path m_target, m_path;
  std::ofstream m_out;

public:
  /// A link stays a link: it is what it points to that is written.
  explicit Temporary_file(const std::filesystem::path& target);
  ~Temporary_file();
  Temporary_file(const Temporary_file&) = delete;
  Temporary_file& operator=(const Temporary_file&) = delete;

  std::ostream& stream() { return m_out; }
  const std::filesystem::path& path() const { return m_path; }

  /// Replaces the target, at once and only when all is on the disk.
  void take_place();
};

} // namespace point_files

#endif // POINT_FILES_TEMPORARY_FILE_H
