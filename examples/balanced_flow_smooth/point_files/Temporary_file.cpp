// SPDX-License-Identifier: GPL-3.0-or-later
#include "Temporary_file.h"

#include <fcntl.h>
#include <sys/file.h>
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

const std::string extension = ".part";

/// The name of the target of a temporary file; empty if it is none
std::string target_of(const std::string& name)
{
  if (name.size() <= extension.size() ||
      name.compare(name.size() - extension.size(), extension.size(), extension) != 0)
    return "";
  const std::string without = name.substr(0, name.size() - extension.size());
  const std::size_t dot = without.find_last_not_of("0123456789");
  const bool has_number = dot != std::string::npos && dot + 1 < without.size();
  return has_number && without[dot] == '.' ? without.substr(0, dot) : "";
}

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
    : m_target(std::filesystem::weakly_canonical(target))
{
  struct stat old, status;
  const bool exists = ::stat(m_target.c_str(), &old) == 0;
  do { // until nobody has taken it for abandoned before it was locked
    if (m_lock >= 0)
      ::close(m_lock);
    m_path = m_target.string() + "." + std::to_string(std::random_device()()) + extension;
    // who may not read the old file can not read the new one while it is written
    m_lock = ::open(m_path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC,
                    exists ? old.st_mode & 0700 : 0666);
    if (m_lock < 0)
      throw std::runtime_error("no file can be written in this directory: " +
                               std::generic_category().message(errno));
  } while (::flock(m_lock, LOCK_EX) == 0 && ::fstat(m_lock, &status) == 0 && status.st_nlink == 0);
  if (exists) {
    // the owner first, since it takes away permissions; who is not root keeps their own
    [[maybe_unused]] const int ignored = ::fchown(m_lock, old.st_uid, old.st_gid);
    ::fchmod(m_lock, old.st_mode & 07777);
  }
  m_out.open(m_path, std::ios::binary);
}

Temporary_file::~Temporary_file()
{
  m_out.close();
  std::error_code ignored;
  std::filesystem::remove(m_path, ignored);
  ::close(m_lock);
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

void remove_abandoned(const std::filesystem::path& directory,
                      const std::function<bool(const std::string& name)>& is_target)
{
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(directory, ignored)) {
    const std::string target = target_of(entry.path().filename().string());
    if (target.empty() || !is_target(target))
      continue;
    const int file = ::open(entry.path().c_str(), O_WRONLY | O_NOFOLLOW | O_CLOEXEC);
    if (file >= 0 && ::flock(file, LOCK_EX | LOCK_NB) == 0)
      std::filesystem::remove(entry.path(), ignored);
    if (file >= 0)
      ::close(file);
  }
}

} // namespace point_files
