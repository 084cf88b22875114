// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_BLOCKS_DIRECTORY_LOCK_H
#define BALANCED_FLOW_BLOCKS_DIRECTORY_LOCK_H

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <filesystem>
#include <stdexcept>
#include <string>

namespace balanced_flow_blocks {

/// Keeps other processes from doing the same in a directory. The kernel releases it when a process ends, however it
/// ends.
class Directory_lock {
  int m_file;

public:
  Directory_lock(const std::filesystem::path& directory, const std::string& command)
      : m_file(
            ::open((directory / ("lock." + command)).c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600))
  {
    if (m_file < 0)
      throw std::runtime_error("cannot write to the directory " + directory.string());
    if (::flock(m_file, LOCK_EX | LOCK_NB) != 0) {
      ::close(m_file);
      throw std::runtime_error("another process does the command " + command + " in " +
                               directory.string());
    }
  }
  ~Directory_lock() { ::close(m_file); }
  Directory_lock(const Directory_lock&) = delete;
  Directory_lock& operator=(const Directory_lock&) = delete;
};

} // namespace balanced_flow_blocks

#endif // BALANCED_FLOW_BLOCKS_DIRECTORY_LOCK_H
