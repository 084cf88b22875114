// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_FILES_TEMPORARY_FILE_H
#define POINT_FILES_TEMPORARY_FILE_H

#include <filesystem>
#include <fstream>
#include <functional>
#include <ostream>
#include <string>

namespace point_files {

/// A new file beside the one to be written; removed unless it takes that one's place, or
/// else it is the old file that is removed.
class Temporary_file {
  std::filesystem::path m_target, m_path;
  int m_lock = -1; // the file, locked as long as this process lives
  std::ofstream m_out;
  bool m_is_finished = false;
  bool m_is_exchanged = false; // whether the old file has the path of this one now
  bool m_is_new = false;       // whether there was no old file

public:
  /// A link stays a link: it is what it points to that is written.
  explicit Temporary_file(const std::filesystem::path& target);
  ~Temporary_file();
  Temporary_file(const Temporary_file&) = delete;
  Temporary_file& operator=(const Temporary_file&) = delete;

  std::ostream& stream() { return m_out; }
  const std::filesystem::path& path() const { return m_path; }
  const std::filesystem::path& target() const { return m_target; }

  /// Puts all that was written on the disk; throws `std::runtime_error` if that fails.
  void finish();

  /// Replaces the target, at once, when `finish()` is done.
  /// \param may_come_back whether `give_back_place()` may be called: the old file is kept until this
  /// one is destroyed, where the file system can exchange files
  void take_place(bool may_come_back = false);

  /// Puts the target back as it was, as far as possible.
  void give_back_place() noexcept;
};

/// Removes temporary files that processes have left behind which were killed. Those in use are locked, and stay.
/// \param is_target tells by its name whether files beside this one are meant
void remove_abandoned(const std::filesystem::path& directory,
                      const std::function<bool(const std::string& name)>& is_target);

} // namespace point_files

#endif // POINT_FILES_TEMPORARY_FILE_H
