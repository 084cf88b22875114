// SPDX-License-Identifier: GPL-3.0-or-later
#include "Ply_stream.h"

#include "../Raw_file.h"
#include "Ply_header.h"
#include "las/Input.h"

#include <algorithm>
#include <cstddef>
#include <sstream>
#include <utility>

namespace point_files {

namespace {

constexpr std::size_t longest_header = std::size_t(1) << 20;

class Ply_stream : public Streamed_file {
  las::Input m_input;
  Ply_header m_header;
  std::size_t m_record_size = 0;
  Layout m_layout;

public:
  explicit Ply_stream(const std::filesystem::path& path)
      : m_input(path), m_header(first_bytes(m_input), std::size_t(m_input.size()))
  {
    if (!is_streamed())
      return;
    const Ply_element& element = m_header.elements.front();
    m_record_size = element.fixed_size();
    m_layout = Layout(element.properties);
    count = element.count;
    has_normals = m_layout.has_normals();
    if (count > (m_input.size() - m_header.end) / m_record_size)
      throw std::runtime_error("the file is too short for " + std::to_string(count) + " points");
    warnings = records(0, (std::min)(count, std::uint64_t(1))).warnings;
  }

  bool is_streamed() const
  {
    const std::vector<Ply_element>& elements = m_header.elements;
    return m_header.encoding != Encoding::TEXT && !elements.empty() &&
           elements.front().has_points() && !elements.front().has_lists() &&
           elements.front().count != 0;
  }

  void for_each_chunk(const Visitor& visit) const override
  {
    for (std::uint64_t i = 0; i < count; i += points_in_chunk) {
      Raw_file file = records(i, chunk_size(i));
      visit({std::move(file.points), std::move(file.normals)});
    }
  }

  void write(const Target& target, const New_points& points) const override
  {
    m_input.check_unchanged();
    m_input.copy(0, m_header.end, target.out);
    for (std::uint64_t i = 0; i < count; i += points_in_chunk) {
      Raw_file file = records(i, chunk_size(i));
      Chunk_of_points chunk = {std::move(file.points), std::move(file.normals)};
      points.replace(i, chunk);
      file.points = std::move(chunk.points);
      file.normals = std::move(chunk.normals);
      file.write(target);
    }
    m_input.copy(m_header.end + count * m_record_size, m_input.size(), target.out);
    m_input.check_unchanged();
  }

private:
  static std::string first_bytes(const las::Input& input)
  {
    return input.read(0, std::size_t((std::min)(input.size(), std::uint64_t(longest_header))));
  }

  std::uint64_t chunk_size(std::uint64_t first) const
  {
    return (std::min)(count - first, std::uint64_t(points_in_chunk));
  }

  /// Some of the records as a file of their own
  Raw_file records(std::uint64_t first, std::uint64_t number) const
  {
    Anatomy anatomy;
    anatomy.bytes =
        m_input.read(m_header.end + first * m_record_size, std::size_t(number) * m_record_size);
    anatomy.encoding = m_header.encoding;
    anatomy.layout = m_layout;
    anatomy.blocks = {{Place{nullptr}, std::size_t(number)}};
    return Raw_file(std::move(anatomy));
  }
};

} // namespace

std::unique_ptr<Streamed_file> open_ply_stream(const std::filesystem::path& path)
{
  auto file = std::make_unique<Ply_stream>(path);
  if (!file->is_streamed())
    return nullptr;
  return file;
}

} // namespace point_files
