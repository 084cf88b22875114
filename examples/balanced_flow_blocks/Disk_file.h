// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_BLOCKS_DISK_FILE_H
#define BALANCED_FLOW_BLOCKS_DISK_FILE_H

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

namespace balanced_flow_blocks {

/// A file of the working directory. What does not succeed throws `std::runtime_error` with the name of the file.
class Disk_file {
  std::filesystem::path m_path;
  int m_file = -1;

public:
  enum Use { READ, WRITE };

  /// \param use a file to write is new and empty
  Disk_file(const std::filesystem::path& path, Use use);
  ~Disk_file();
  Disk_file(const Disk_file&) = delete;
  Disk_file& operator=(const Disk_file&) = delete;

  void read(std::uint64_t at, char* bytes, std::size_t count) const;
  /// Adds bytes at the end.
  void append(const char* bytes, std::size_t count);
  /// Waits until all is on the disk.
  void synchronize();
  std::uint64_t size() const;
};

/// Removes the files of a directory whose names begin so, and go on with a dot and a number or not at all.
void remove_files(const std::filesystem::path& directory, const std::string& name);

} // namespace balanced_flow_blocks

#endif // BALANCED_FLOW_BLOCKS_DISK_FILE_H
