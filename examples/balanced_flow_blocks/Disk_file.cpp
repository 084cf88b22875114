// SPDX-License-Identifier: GPL-3.0-or-later
#include "Disk_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

namespace balanced_flow_blocks {

namespace {

[[noreturn]] void fail(const std::string& what, const std::filesystem::path& path)
{
  throw std::runtime_error("cannot " + what + " " + path.string() + ": " +
                           std::generic_category().message(errno));
}

} // namespace

Disk_file::Disk_file(const std::filesystem::path& path, Use use)
    : m_path(path),
      m_file(::open(path.c_str(),
                    use == READ ? O_RDONLY | O_CLOEXEC : O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC,
                    0600))
{
  if (m_file < 0)
    fail(use == READ ? "read" : "write", path);
}

Disk_file::~Disk_file() { ::close(m_file); }

void Disk_file::read(std::uint64_t at, char* bytes, std::size_t count) const
{
  while (count != 0) {
    const ssize_t done = ::pread(m_file, bytes, count, off_t(at));
    if (done < 0 && errno == EINTR)
      continue;
    if (done < 0)
      fail("read", m_path);
    if (done == 0)
      throw std::runtime_error(m_path.string() + " is damaged: it is too short");
    bytes += done;
    at += std::uint64_t(done);
    count -= std::size_t(done);
  }
}

void Disk_file::append(const char* bytes, std::size_t count)
{
  while (count != 0) {
    const ssize_t done = ::write(m_file, bytes, count);
    if (done < 0 && errno == EINTR)
      continue;
    if (done < 0)
      fail("write", m_path);
    bytes += done;
    count -= std::size_t(done);
  }
}

void Disk_file::synchronize()
{
  if (::fsync(m_file) != 0)
    fail("write", m_path);
}

std::uint64_t Disk_file::size() const
{
  struct stat status;
  if (::fstat(m_file, &status) != 0)
    fail("read", m_path);
  return std::uint64_t(status.st_size);
}

void remove_files(const std::filesystem::path& directory, const std::string& name)
{
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(directory)) {
    const std::string other = entry.path().filename().string();
    const std::string rest =
        other.compare(0, name.size(), name) == 0 ? other.substr(name.size()) : "?";
    if (rest.empty() ||
        (rest[0] == '.' && rest.find_first_not_of("0123456789", 1) == std::string::npos))
      files.push_back(entry.path());
  }
  for (const std::filesystem::path& file : files)
    std::filesystem::remove(file);
}

} // namespace balanced_flow_blocks
