// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_FILES_LAS_BYTES_H
#define POINT_FILES_LAS_BYTES_H

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>

namespace point_files::las {

// LAS has its least significant bytes first, whatever the machine.

/// The unsigned integer with as many bytes as `T`
template <typename T>
using Bits = std::conditional_t<
    sizeof(T) == 1, std::uint8_t,
    std::conditional_t<sizeof(T) == 2, std::uint16_t,
                       std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>>>;

/// Reads a number of type `T`; compilers make one load of it where the order of bytes is the same.
template <typename T>
T get(const char* bytes)
{
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < sizeof(T); ++i)
    bits |= std::uint64_t(static_cast<unsigned char>(bytes[i])) << (8 * i);
  const auto typed = static_cast<Bits<T>>(bits);
  T number;
  std::memcpy(&number, &typed, sizeof number);
  return number;
}

template <typename T>
void put(char* bytes, T number)
{
  Bits<T> typed;
  std::memcpy(&typed, &number, sizeof number);
  for (std::size_t i = 0; i < sizeof(T); ++i)
    bytes[i] = static_cast<char>(std::uint64_t(typed) >> (8 * i) & 0xff);
}

/// A text that fills its place with zeros
inline std::string get_text(const char* bytes, std::size_t size)
{
  const std::string text(bytes, size);
  return text.substr(0, text.find('\0'));
}

} // namespace point_files::las

#endif // POINT_FILES_LAS_BYTES_H
