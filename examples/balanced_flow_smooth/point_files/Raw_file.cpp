// SPDX-License-Identifier: GPL-3.0-or-later
#include "Raw_file.h"

#include "Record_cursor.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <ostream>
#include <stdexcept>

namespace point_files {

bool is_little_endian()
{
  const std::uint16_t one = 1;
  return reinterpret_cast<const char&>(one) == 1;
}

Raw_file::Raw_file(Anatomy file) : m_file(std::move(file))
{
  m_file.first.bytes = &m_file.bytes;
  load(m_file.count, m_file.layout.has_normals());
}

template <typename Function>
void Raw_file::with_cursor(const Function& f) const
{
  if (m_file.encoding == Encoding::TEXT)
    f(Text_cursor(m_file.first, m_file.layout, false));
  else
    f(Binary_cursor(m_file.first, m_file.layout, m_file.encoding == Encoding::SWAPPED_BINARY));
}

template <typename Cursor>
const std::vector<Field>& Raw_file::next(Cursor& cursor, std::size_t i) const
{
  const std::vector<Field>* fields = cursor.next();
  if (!fields)
    throw std::runtime_error("the file ends after " + std::to_string(i) + " of " +
                             std::to_string(m_file.count) + " points");
  return *fields;
}

template <typename Cursor>
void Raw_file::go_through(Cursor& cursor, bool with_values, const Visitor& visit) const
{
  const Layout& layout = m_file.layout;
  const std::vector<std::size_t> others =
      with_values ? layout.others() : std::vector<std::size_t>();
  Record record = {{0., 0., 0.}, {0., 0., 0.}, std::vector<double>(others.size())};
  for (std::size_t i = 0; i < m_file.count; ++i) {
    const std::vector<Field>& fields = next(cursor, i);
    const auto value = [&](std::size_t p) {
      return cursor.value(fields[p], layout.properties()[p].type);
    };
    for (std::size_t c = 0; c < 3; ++c)
      record.coordinates[c] = value(layout.coordinates()[c]);
    for (std::size_t c = 0; layout.has_normals() && c < 3; ++c)
      record.normal[c] = value(layout.normals()[c]);
    for (std::size_t c = 0; c < others.size(); ++c)
      record.values[c] = value(others[c]);
    visit(record);
  }
}

/// The properties that may change, in the order of the record: 0 to 2 tell the coordinate that each
/// is, 3 to 5 that of the normal.
std::vector<std::pair<std::size_t, std::size_t>> Raw_file::changing_properties() const
{
  const Layout& layout = m_file.layout;
  std::vector<std::pair<std::size_t, std::size_t>> places;
  for (std::size_t c = 0; c < 3; ++c) {
    places.emplace_back(layout.coordinates()[c], c);
    if (layout.has_normals())
      places.emplace_back(layout.normals()[c], c + 3);
  }
  std::sort(places.begin(), places.end());
  return places;
}

template <typename Cursor>
void Raw_file::write_with(Cursor& cursor, std::ostream& out) const
{
  const Layout& layout = m_file.layout;
  const bool swapped = m_file.encoding == Encoding::SWAPPED_BINARY;
  const bool new_normals = !normals.empty() && !layout.has_normals();
  const auto places = changing_properties();

  std::string text; // waits to be written
  std::size_t done = 0;
  const auto copy_up_to = [&](std::size_t end) {
    text.append(m_file.bytes, done, end - done);
    done = end;
  };
  if (new_normals) {
    copy_up_to(m_file.normals_header.first);
    text += m_file.normals_header.second;
  }
  for (std::size_t i = 0; i < m_file.count; ++i) {
    const std::vector<Field>& fields = next(cursor, i);
    for (const auto& [p, c] : places) {
      const Scalar type = layout.properties()[p].type;
      const double before = cursor.value(fields[p], type);
      const double now = c < 3 ? points[i][int(c)] : normals[i][int(c) - 3];
      if (now == before || (std::isnan(now) && std::isnan(before)))
        continue;
      copy_up_to(fields[p].begin);
      Cursor::append(text, type, now, swapped);
      done = fields[p].end;
    }
    if (new_normals) {
      copy_up_to(fields[layout.last_coordinate()].end);
      for (int c = 0; c < 3; ++c) {
        Cursor::append_between(text);
        Cursor::append(text, layout.coordinate_type(), normals[i][c], swapped);
      }
    }
    copy_up_to(cursor.place().at);
    if (text.size() > (std::size_t(1) << 20)) {
      out.write(text.data(), std::streamsize(text.size()));
      text.clear();
    }
  }
  out.write(text.data(), std::streamsize(text.size()));
  out.write(m_file.bytes.data() + done, std::streamsize(m_file.bytes.size() - done));
}

void Raw_file::for_each_record(bool with_values, const Visitor& visit) const
{
  with_cursor([&](auto cursor) { go_through(cursor, with_values, visit); });
}

void Raw_file::write(const Target& target) const
{
  with_cursor([&](auto cursor) { write_with(cursor, target.out); });
}

std::vector<Property> Raw_file::columns() const
{
  std::vector<Property> columns;
  for (const std::size_t i : m_file.layout.others())
    columns.push_back(m_file.layout.properties()[i]);
  return columns;
}

} // namespace point_files
