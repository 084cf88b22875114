// SPDX-License-Identifier: GPL-3.0-or-later
#include "Bytes.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>
#include <system_error>

namespace point_files {

/// A file in the address space
class Bytes::Mapping {
  void* m_begin = nullptr;
  std::size_t m_size = 0, m_passed = 0;

public:
  explicit Mapping(const std::filesystem::path& path)
  {
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0)
      fail();
    struct stat status;
    bool is_mapped = ::fstat(file, &status) == 0;
    if (is_mapped && status.st_size > 0) { // nothing can not be mapped
      m_size = std::size_t(status.st_size);
      m_begin = ::mmap(nullptr, m_size, PROT_READ, MAP_PRIVATE, file, 0);
      is_mapped = m_begin != MAP_FAILED;
    }
    const int error = errno;
    ::close(file);
    errno = error;
    if (!is_mapped)
      fail();
  }
  ~Mapping()
  {
    if (m_size != 0)
      ::munmap(m_begin, m_size);
  }
  Mapping(const Mapping&) = delete;
  Mapping& operator=(const Mapping&) = delete;

  std::string_view view() const { return {static_cast<const char*>(m_begin), m_size}; }

  void pass(std::size_t at)
  {
    const std::size_t step = std::size_t(1) << 24; // a multiple of all sizes of pages
    if (at < m_passed)
      m_passed = at / step * step; // once more
    for (; m_passed + step <= at; m_passed += step)
      ::madvise(static_cast<char*>(m_begin) + m_passed, step, MADV_DONTNEED);
  }

private:
  [[noreturn]] static void fail()
  {
    throw std::runtime_error("the file can not be opened: " +
                             std::generic_category().message(errno));
  }
};

Bytes Bytes::of_file(const std::filesystem::path& path)
{
  Bytes bytes;
  bytes.m_mapping = std::make_shared<Mapping>(path);
  bytes.m_view = bytes.m_mapping->view();
  return bytes;
}

void Bytes::pass(std::size_t at) const
{
  if (m_mapping)
    m_mapping->pass(at);
}

void refuse_wide_characters(const Bytes& bytes)
{
  const auto byte = [&](std::size_t i) {
    return i < bytes.size() ? int(static_cast<unsigned char>(bytes[i])) : -1;
  };
  const auto is_text = [&](std::size_t i) { return byte(i) >= '\t' && byte(i) < 127; };
  const auto is_null = [&](std::size_t i) { return byte(i) == 0; };
  const bool has_mark =
      (byte(0) == 0xFF && byte(1) == 0xFE) || (byte(0) == 0xFE && byte(1) == 0xFF);
  if (has_mark || (is_text(0) && is_null(1) && is_text(2) && is_null(3)) ||
      (is_null(0) && is_text(1) && is_null(2) && is_text(3)))
    throw std::runtime_error(
        "this is text in UTF-16, which is not supported: convert it to UTF-8, for instance by "
        "iconv -f UTF-16 -t UTF-8");
}

} // namespace point_files
