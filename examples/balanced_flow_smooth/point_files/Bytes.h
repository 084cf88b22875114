// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_FILES_BYTES_H
#define POINT_FILES_BYTES_H

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

namespace point_files {

/// The bytes of a file, in memory or on the disk. Copies share them.
class Bytes {
  class Mapping;
  std::shared_ptr<const void> m_owner;
  std::shared_ptr<Mapping> m_mapping; // null if they are in memory
  std::string_view m_view;

public:
  Bytes() = default;
  Bytes(std::string text)
  {
    auto owner = std::make_shared<const std::string>(std::move(text));
    m_view = *owner;
    m_owner = std::move(owner);
  }

  /// Those of a file on the disk, which are read when they are looked at. Throws `std::runtime_error` if they can not be.
  static Bytes of_file(const std::filesystem::path& path);

  /// The bytes before a place
  Bytes up_to(std::size_t end) const
  {
    Bytes some = *this;
    some.m_view = m_view.substr(0, end);
    return some;
  }

  /// Tells that those before a place are not needed in the near future: what was read of a file leaves the memory.
  void pass(std::size_t at) const;

  std::string_view view() const { return m_view; }
  std::size_t size() const { return m_view.size(); }
  const char* data() const { return m_view.data(); }
  const char* begin() const { return m_view.data(); }
  const char* end() const { return m_view.data() + m_view.size(); }
  char operator[](std::size_t i) const { return m_view[i]; }
  std::string substr(std::size_t at, std::size_t count = std::string::npos) const
  {
    return std::string(m_view.substr(at, count));
  }
  std::size_t find(char c, std::size_t at = 0) const { return m_view.find(c, at); }
  std::size_t find_first_of(std::string_view chars, std::size_t at = 0) const
  {
    return m_view.find_first_of(chars, at);
  }
  int compare(std::size_t at, std::size_t count, std::string_view text) const
  {
    return m_view.compare(at, count, text);
  }
};

/// Throws `std::runtime_error` if the text is not one of bytes: it would pass for garbage.
void refuse_wide_characters(const Bytes& bytes);

} // namespace point_files

#endif // POINT_FILES_BYTES_H
