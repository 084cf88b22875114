// SPDX-License-Identifier: GPL-3.0-or-later
// How the bytes of a file come out again
#include "Raw_file.h"

#include <algorithm>
#include <cmath>
#include <ostream>
#include <stdexcept>

namespace point_files {

namespace {

bool is_same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

bool is_same(const Scan_frame::Triple& a, const Scan_frame::Triple& b)
{
  return is_same(a[0], b[0]) && is_same(a[1], b[1]) && is_same(a[2], b[2]);
}

} // namespace

/// The bytes of a file on their way out, with what replaces some of them
struct Raw_file::Output {
  const Bytes& bytes;
  std::ostream& out;
  std::size_t done;      // of the bytes
  std::string text = {}; // waits to be written

  void copy_up_to(std::size_t end)
  {
    text.append(bytes.data() + done, end - done);
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

/// Writes up to the records of a block, with what announces new normals, and with the number of records
/// that are not dropped.
/// \param before the number of points before those of the block
void Raw_file::write_head(const Block& block, std::size_t before, bool with_new_normals,
                          Output& out) const
{
  std::vector<std::pair<Field, std::string>> changes;
  if (with_new_normals)
    for (const Announcement& a : m_file.normals_header)
      changes.push_back({{a.place, a.place}, a.text});
  if (drops_invalid) {
    const auto first = std::lower_bound(invalid.begin(), invalid.end(), before);
    const auto last = std::lower_bound(first, invalid.end(), before + block.count);
    for (const Field& field : block.count_fields)
      changes.push_back({field, std::to_string(block.count - std::size_t(last - first))});
    if (m_file.rows_field)
      changes.push_back({*m_file.rows_field, "1"});
  }
  std::stable_sort(changes.begin(), changes.end(),
                   [](const auto& a, const auto& b) { return a.first.begin < b.first.begin; });
  for (const auto& [field, text] : changes) {
    out.copy_up_to(field.begin);
    out.text += text;
    out.done = field.end;
  }
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
    point = is_same(point, frame->to_shared(before)) ? before : frame->to_own(point);
  }
  const double length = has_integer_normals() ? length_of_normal(cursor, fields) : 0.;
  const double unit = length != 0. ? length : 1.; // of normals
  for (const auto& [p, c] : m_changing) {
    const Scalar type = layout.properties()[p].type;
    const double before = cursor.value(fields[p], type);
    double now = c < 3 ? point[c] : normals[i][int(c) - 3];
    if (is_same(now, c < 3 ? before : before / unit))
      continue; // also what the type can not hold
    if (is_integer(type)) {
      if (c >= 3)
        now *= length != 0. ? length : round_to(type, HUGE_VAL);
      now = round_to(type, now);
    }
    if (is_same(now, before))
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
  Output out = {m_file.bytes, target.out, m_file.begin};
  bool has_new_normals = !normals.empty() && !m_file.layout.has_normals();
  for_each_fields([&](const auto& cursor, const std::vector<Field>& fields, std::size_t i,
                      const Block& block, std::size_t before) {
    if (i == before) {
      write_head(block, before, has_new_normals, out);
      has_new_normals = false;
    }
    if (is_dropped(i))
      drop_record(fields.front().begin, cursor.place().at, out);
    else
      write_record(cursor, fields, i, block.frame.get(), out);
  });
  out.flush();
  target.out.write(m_file.bytes.data() + out.done, std::streamsize(m_file.bytes.size() - out.done));
}

} // namespace point_files
