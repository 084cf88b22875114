// SPDX-License-Identifier: GPL-3.0-or-later
#include "Las_stream.h"

#include "las/Bytes.h"
#include "las/Header.h"
#include "las/Input.h"
#include "las/Records.h"
#include "las/Rewriting.h"

#include <algorithm>
#include <cstddef>

namespace point_files {

namespace {

class Las_stream : public Streamed_file {
  las::Input m_input;
  las::Header m_header;

public:
  explicit Las_stream(const std::filesystem::path& file) : m_input(file), m_header(m_input)
  {
    format = find_format(m_header.is_compressed ? "laz" : "las"); // whatever its name
    check_support(*format);
    count = m_header.count;
  }

  void for_each_chunk(const Visitor& visit) const override
  {
    const auto reader = las::make_reader(m_input, m_header);
    Chunk_of_points chunk;
    for (std::uint64_t i = 0; i < count;) {
      try_to_read([&] { read(*reader, i, chunk); });
      i += chunk.points.size();
      visit(chunk);
    }
  }

  void write(const Target& target, const New_points& points) const override
  {
    std::unique_ptr<las::Record_reader> reader;
    Chunk_of_points chunk;
    std::size_t first = 0;
    las::Rewriting rewriting(m_input, m_header);
    rewriting.point = [&](std::size_t i) {
      if (i == 0)
        reader = las::make_reader(m_input, m_header), first = 0, chunk.points.clear();
      if (i - first == chunk.points.size()) {
        first = i;
        try_to_read([&] { read(*reader, i, chunk); });
        points.replace(i, chunk);
      }
      return chunk.points[i - first];
    };
    rewriting.write(target);
  }

private:
  void read(las::Record_reader& reader, std::uint64_t first, Chunk_of_points& chunk) const
  {
    chunk.points.clear();
    for (std::uint64_t i = first; i < count && chunk.points.size() < points_in_chunk; ++i) {
      const char* const bytes = reader.next();
      const auto coordinate = [&](std::size_t c) {
        return m_header.grid.coordinate(las::get<std::int32_t>(bytes + 4 * c), c);
      };
      chunk.points.emplace_back(coordinate(0), coordinate(1), coordinate(2));
    }
  }
};

} // namespace

std::unique_ptr<Streamed_file> open_las_stream(const std::filesystem::path& path,
                                               const Read_options&)
{
  return std::make_unique<Las_stream>(path);
}

} // namespace point_files
