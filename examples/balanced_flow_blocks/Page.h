// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_BLOCKS_PAGE_H
#define BALANCED_FLOW_BLOCKS_PAGE_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace balanced_flow_blocks {

/// Points of the working directory: coordinates, a normal if there are any, and the number of the point in
/// all inputs, from 0 on. Each is a few words of 8 bytes, in the order of bytes of this machine.
class Records {
  std::size_t m_width;
  std::vector<std::uint64_t> m_words;

public:
  explicit Records(bool has_normals) : m_width(has_normals ? 7 : 4) {}

  static std::size_t bytes_of(bool has_normals) { return has_normals ? 56 : 32; }

  std::size_t size() const { return m_words.size() / m_width; }
  std::size_t record_size() const { return m_width * sizeof(std::uint64_t); }
  bool has_normals() const { return m_width == 7; }

  double value(std::size_t i, std::size_t c) const
  {
    double value;
    std::memcpy(&value, &m_words[i * m_width + c], sizeof value);
    return value;
  }
  void set_value(std::size_t i, std::size_t c, double value)
  {
    std::memcpy(&m_words[i * m_width + c], &value, sizeof value);
  }
  std::uint64_t number(std::size_t i) const { return m_words[(i + 1) * m_width - 1]; }
  void set_number(std::size_t i, std::uint64_t number) { m_words[(i + 1) * m_width - 1] = number; }

  void resize(std::size_t n) { m_words.resize(n * m_width); }
  void reserve(std::size_t n) { m_words.reserve(n * m_width); }
  /// \param other of the same width
  void append(const Records& other, std::size_t i)
  {
    const auto first = other.m_words.begin() + std::ptrdiff_t(i * m_width);
    m_words.insert(m_words.end(), first, first + std::ptrdiff_t(m_width));
  }

  char* bytes() { return reinterpret_cast<char*>(m_words.data()); }
  const char* bytes() const { return reinterpret_cast<const char*>(m_words.data()); }
  std::size_t byte_count() const { return m_words.size() * sizeof(std::uint64_t); }
};

/// A box with faces parallel to the axes
struct Box {
  std::array<double, 3> low, high;

  Box(); // an empty one
  void add(const std::array<double, 3>& p);
  void add(const Box& box);

  /// rounded down
  double distance(const std::array<double, 3>& p) const;
  double distance(const Box& box) const;
};

/// Points that are read at once: a few thousand that are near each other, in the file of a block
struct Page {
  Box box; // of its points
  std::uint64_t first = 0;
  std::uint64_t checksum = 0;
  std::uint32_t count = 0, block = 0;

  /// The distance between its points, as if they were a surface
  double spacing() const;
};

/// A checksum of bytes, of 64 bits
class Checksum {
  std::uint64_t m_value = 0xcbf29ce484222325;

public:
  void add(const char* bytes, std::size_t count);
  std::uint64_t value() const { return m_value; }
  static std::uint64_t of(const char* bytes, std::size_t count)
  {
    Checksum checksum;
    checksum.add(bytes, count);
    return checksum.value();
  }
};

} // namespace balanced_flow_blocks

#endif // BALANCED_FLOW_BLOCKS_PAGE_H
