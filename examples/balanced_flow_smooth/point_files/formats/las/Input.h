// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_FILES_LAS_INPUT_H
#define POINT_FILES_LAS_INPUT_H

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <istream>
#include <memory>
#include <ostream>
#include <string>

namespace point_files::las {

/// The bytes of a file, read where they are needed: the records of the points are never in memory at
/// once. The file stays open, so that it may be replaced by what is written.
class Input {
  std::unique_ptr<std::istream> m_in;
  std::uint64_t m_size = 0;
  std::filesystem::path m_path; // empty if the bytes are in memory
  std::filesystem::file_time_type m_time;

public:
  explicit Input(const std::filesystem::path& path);
  explicit Input(std::string bytes);

  std::uint64_t size() const { return m_size; }

  /// Throws `std::runtime_error` if the bytes are not there.
  void read(std::uint64_t at, char* to, std::size_t count) const;
  std::string read(std::uint64_t at, std::size_t count) const;

  /// Copies the bytes from `begin` to `end`.
  void copy(std::uint64_t begin, std::uint64_t end, std::ostream& out) const;

  /// The stream, at its beginning, for those who read it themselves
  std::istream& stream() const;

  /// Throws `std::runtime_error` if somebody else has written to the file since it was opened.
  void check_unchanged() const;
};

} // namespace point_files::las

#endif // POINT_FILES_LAS_INPUT_H
