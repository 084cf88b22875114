// SPDX-License-Identifier: GPL-3.0-or-later
#include "Raw_stream.h"

#include <algorithm>
#include <stdexcept>

namespace point_files {

Raw_stream::Raw_stream(Anatomy file) : m_file(std::move(file))
{
  scans.clear();
  has_normals = m_file.layout.has_normals();
  defines_invalid = m_file.defines_invalid;
  zeros_are_invalid = m_file.zeros_are_invalid;
  for (const Block& block : m_file.blocks) {
    if (block.count != 0)
      scans.push_back(count);
    count += block.count;
    has_views = has_views || block.frame;
  }
  for (const Block& block : m_file.blocks)
    if (block.count != 0 && warnings.empty()) {
      Place first = block.first;
      first.bytes = &m_file.bytes;
      warnings = Raw_file(piece(block, first, skip(first, 1), 0, 1)).warnings;
    }
}

void Raw_stream::for_each_chunk(const Visitor& visit) const
{
  for_each_piece([&](Raw_file& file, std::uint64_t) {
    visit({std::move(file.points), std::move(file.normals), std::move(file.sides)});
  });
}

void Raw_stream::write(const Target& target, const New_points& points) const
{
  std::size_t written = m_file.begin;
  for_each_piece([&](Raw_file& file, std::uint64_t first) {
    Chunk_of_points chunk = {std::move(file.points), std::move(file.normals), {}};
    points.replace(first, chunk);
    file.points = std::move(chunk.points);
    file.normals = std::move(chunk.normals);
    file.write(target);
    written = file.end_of_bytes();
  });
  const std::size_t step = std::size_t(1) << 20;
  for (; written < m_file.bytes.size(); written += step) {
    const std::size_t size = (std::min)(step, m_file.bytes.size() - written);
    target.out.write(m_file.bytes.data() + written, std::streamsize(size));
    m_file.bytes.pass(written);
  }
}

/// Calls `visit(file, first)` for some records after the other, with the number of the first point. All are of one
/// scan. What is between the records belongs to those behind it.
template <typename Visit>
void Raw_stream::for_each_piece(const Visit& visit) const
{
  std::uint64_t first = 0;
  std::size_t begin = m_file.begin;
  for (const Block& block : m_file.blocks) {
    Place place = block.first;
    place.bytes = &m_file.bytes;
    for (std::size_t left = block.count; left != 0;) {
      const std::size_t size = (std::min)(left, points_in_chunk);
      const Place end = try_to_read([&] { return skip(place, size); });
      const auto file = try_to_read(
          [&] { return std::make_unique<Raw_file>(piece(block, place, end, begin, size)); });
      visit(*file, first);
      m_file.bytes.pass(end.at);
      first += size;
      left -= size;
      begin = end.at;
      place = end;
    }
  }
}

/// Some records as a file of their own
Anatomy Raw_stream::piece(const Block& block, const Place& first, const Place& last,
                          std::size_t begin, std::size_t size) const
{
  Anatomy file;
  file.bytes = m_file.bytes.up_to(last.at);
  file.begin = begin;
  file.encoding = m_file.encoding;
  file.style = m_file.style;
  file.layout = m_file.layout;
  file.has_types = m_file.has_types;
  file.warnings = m_file.warnings;
  file.blocks = {{first, size, {}, block.frame}};
  return file;
}

/// \return the place behind so many records
Place Raw_stream::skip(const Place& place, std::size_t number_of_records) const
{
  const auto with_cursor = [&](auto cursor) {
    for (std::size_t i = 0; i < number_of_records; ++i)
      if (!cursor.next())
        throw std::runtime_error("the file was shortened while it was read");
    return cursor.place();
  };
  const std::vector<Property>& properties = m_file.layout.properties();
  return m_file.encoding == Encoding::TEXT
             ? with_cursor(Text_cursor(place, properties, m_file.style))
             : with_cursor(
                   Binary_cursor(place, properties, m_file.encoding == Encoding::SWAPPED_BINARY));
}

} // namespace point_files
