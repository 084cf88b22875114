// SPDX-License-Identifier: GPL-3.0-or-later
#include "Temporary_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <random>
#include <stdexcept>
#include <string>
#include <system_error>

namespace point_files {

namespace {

bool synchronize(const std::filesystem::path& path)
{
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  const bool done = file >= 0 && ::fsync(file) == 0;
  if (file >= 0)
    ::close(file);
  return done;
}

/// Exchanges two files at once, so that both still exist.
/// \return whether system and file system can do that
bool exchange([[maybe_unused]] const std::filesystem::path& a,
              [[maybe_unused]] const std::filesystem::path& b)
{
#ifdef RENAME_EXCHANGE
  return ::renameat2(AT_FDCWD, a.c_str(), AT_FDCWD, b.c_str(), RENAME_EXCHANGE) == 0;
#else
  return false;
#endif
}

} // namespace

Temporary_file::Temporary_file(const std::filesystem::path& target)
    : m_target(std::filesystem::weakly_canonical(target)),
      m_path(m_target.string() + "." + std::to_string(std::random_device()()) + ".part")
{
  struct stat status;
  const bool exists = ::stat(m_target.c_str(), &status) == 0;
  // who may not read the old file can not read the new one while it is written
  const int file = ::open(m_path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC,
                          exists ? status.st_mode & 0700 : 0666);
  if (file < 0)
    throw std::runtime_error("no file can be written in this directory: " +
                             std::generic_category().message(errno));
  if (exists) {
    // the owner first, since it takes away permissions; who is not root keeps their own
    [[maybe_unused]] const int ignored = ::fchown(file, status.st_uid, status.st_gid);
    ::fchmod(file, status.st_mode & 07777);
  }
  ::close(file);
  m_out.open(m_path, std::ios::binary);
}

Temporary_file::~Temporary_file()
{
  m_out.close();
  std::error_code ignored;
  std::filesystem::remove(m_path, ignored);
}

void Temporary_file::finish()
{
  if (m_is_finished)
    return;
  m_out.close();
  if (!m_out || !synchronize(m_path))
    throw std::runtime_error("writing failed");
  m_is_finished = true;
}

void Temporary_file::take_place(bool may_come_back)
{
  finish(); // or else what was not written would pass for the whole
  const auto status = std::filesystem::status(m_target);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    throw std::runtime_error("this is not a regular file"); // anymore
  m_is_new = !std::filesystem::exists(status);
  m_is_exchanged = may_come_back && !m_is_new && exchange(m_path, m_target);
  if (!m_is_exchanged)
    std::filesystem::rename(m_path, m_target);
  synchronize(m_target.parent_path());
}

void Temporary_file::give_back_place() noexcept
{
  std::error_code ignored;
  if (m_is_new)
    std::filesystem::remove(m_target, ignored);
  else if (m_is_exchanged)
    std::filesystem::rename(m_path, m_target, ignored);
}

} // namespace point_files
