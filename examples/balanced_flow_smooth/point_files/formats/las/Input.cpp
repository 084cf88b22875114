// SPDX-License-Identifier: GPL-3.0-or-later
#include "Input.h"

#include <algorithm>
#include <fstream>
#include <ios>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace point_files::las {

Input::Input(const std::filesystem::path& path)
    : m_in(std::make_unique<std::ifstream>(path, std::ios::binary)), m_path(path)
{
  if (!*m_in)
    throw std::runtime_error("the file can not be opened");
  m_size = std::filesystem::file_size(path);
  m_time = std::filesystem::last_write_time(path);
}

Input::Input(std::string bytes)
    : m_in(std::make_unique<std::istringstream>(bytes, std::ios::binary)), m_size(bytes.size())
{}

void Input::read(std::uint64_t at, char* to, std::size_t count) const
{
  m_in->clear();
  m_in->seekg(std::streamoff(at));
  m_in->read(to, std::streamsize(count));
  if (m_in->gcount() != std::streamsize(count))
    throw std::runtime_error("reading " + std::to_string(count) + " bytes from byte " +
                             std::to_string(at) + " on failed");
}

std::string Input::read(std::uint64_t at, std::size_t count) const
{
  std::string bytes(count, '\0');
  read(at, bytes.data(), count);
  return bytes;
}

void Input::copy(std::uint64_t begin, std::uint64_t end, std::ostream& out) const
{
  std::string chunk;
  while (begin < end && out) {
    chunk.resize(std::size_t((std::min)(end - begin, std::uint64_t(1) << 20)));
    read(begin, chunk.data(), chunk.size());
    out.write(chunk.data(), std::streamsize(chunk.size()));
    begin += chunk.size();
  }
}

std::istream& Input::stream() const
{
  m_in->clear();
  m_in->seekg(0);
  return *m_in;
}

void Input::check_unchanged() const
{
  std::error_code is_gone; // or moved, which does no harm
  const auto time = std::filesystem::last_write_time(m_path, is_gone);
  if (!is_gone && time != m_time)
    throw std::runtime_error("the input was changed by another program in the meantime");
}

} // namespace point_files::las
