// SPDX-License-Identifier: GPL-3.0-or-later
// How the bytes of a file come out again
#include "Raw_file.h"

#include <algorithm>
#include <cmath>
#include <ostream>
#include <stdexcept>

namespace point_files {

/// The bytes of a file on their way out, with what replaces some of them
struct Raw_file::Output {
  const std::string& bytes;
  std::ostream& out;
  std::string text = {}; // waits to be written
  std::size_t done = 0;  // of the bytes

  void copy_up_to(std::size_t end)
  {
    text.append(bytes, done, end - done);
    done = end;
    if (text.size() > (std::size_t(1) << 20))
      flush();
  }
  void flush()
  {
    out.write(text.data(), std::streamsize(text.size()));
    text.clear();
  }
};

/// Writes what announces new normals.
void Raw_file::write_header_of_normals(Output& out) const
{
  out.copy_up_to(m_file.normals_header.first);
  out.text += m_file.normals_header.second;
}

/// Writes up to the records of a block, with the number of those that are not dropped.
void Raw_file::write_count(const Block& block, std::size_t before, Output& out) const
{
  if (!drops_invalid || !block.count_field)
    return;
  const auto first = std::lower_bound(invalid.begin(), invalid.end(), before);
  const auto last = std::lower_bound(first, invalid.end(), before + block.count);
  out.copy_up_to(block.count_field->begin);
  out.text += std::to_string(block.count - std::size_t(last - first));
  out.done = block.count_field->end;
}

/// Leaves out the bytes of a record, of text with all of its lines.
/// \param begin where its first field is
void Raw_file::drop_record(std::size_t begin, std::size_t end, Output& out) const
{
  if (m_file.encoding == Encoding::TEXT)
    while (begin > out.done && m_file.bytes[begin - 1] != '\n' && m_file.bytes[begin - 1] != '\r')
      --begin;
  out.copy_up_to(begin);
  out.done = end;
}

/// Writes the bytes up to the end of a record, with the point and the normal that are now here.
template <typename Cursor>
void Raw_file::write_record(const Cursor& cursor, const std::vector<Field>& fields, std::size_t i,
                            const Scan_frame* frame, Output& out) const
{
  const Layout& layout = m_file.layout;
  Scan_frame::Triple point = {points[i].x(), points[i].y(), points[i].z()};
  if (frame) {
    const Scan_frame::Triple before = coordinates(cursor, fields);
    point = point == frame->to_shared(before) ? before : frame->to_own(point);
  }
  for (const auto& [p, c] : m_changing) {
    const Scalar type = layout.properties()[p].type;
    const double before = cursor.value(fields[p], type);
    double now = c < 3 ? point[c] : normals[i][int(c) - 3];
    if (is_integer(type)) {
      if (c >= 3) {
        const double length = length_of_normal(cursor, fields);
        now *= length != 0. ? length : round_to(type, HUGE_VAL);
      }
      now = round_to(type, now);
    }
    if (now == before || (std::isnan(now) && std::isnan(before)))
      continue;
    out.copy_up_to(fields[p].begin);
    cursor.append(out.text, type, now);
    out.done = fields[p].end;
  }
  if (!normals.empty() && !layout.has_normals()) {
    out.copy_up_to(cursor.end_of(fields[layout.last_coordinate()]));
    for (int c = 0; c < 3; ++c) {
      cursor.append_between(out.text);
      cursor.append(out.text, layout.normal_type(), normals[i][c]);
    }
  }
  out.copy_up_to(cursor.place().at);
}

void Raw_file::write(const Target& target) const
{
  if (drops_invalid && !m_file.obstacle_to_dropping.empty())
    throw std::runtime_error("no points can be dropped: " + m_file.obstacle_to_dropping);
  if (!normals.empty() && !m_file.has_place_for_normals)
    throw std::runtime_error("the format has no place for normals");
  Output out = {m_file.bytes, target.out};
  bool has_new_normals = !normals.empty() && !m_file.layout.has_normals();
  const auto write_head = [&](const Block& block, std::size_t before) {
    const bool count_comes_first =
        block.count_field && block.count_field->begin < m_file.normals_header.first;
    if (count_comes_first)
      write_count(block, before, out);
    if (has_new_normals)
      write_header_of_normals(out);
    has_new_normals = false;
    if (!count_comes_first)
      write_count(block, before, out);
  };
  for_each_fields([&](const auto& cursor, const std::vector<Field>& fields, std::size_t i,
                      const Block& block, std::size_t before) {
    if (i == before)
      write_head(block, before);
    if (is_dropped(i))
      drop_record(fields.front().begin, cursor.place().at, out);
    else
      write_record(cursor, fields, i, block.frame.get(), out);
  });
  out.flush();
  target.out.write(m_file.bytes.data() + out.done, std::streamsize(m_file.bytes.size() - out.done));
}

} // namespace point_files
