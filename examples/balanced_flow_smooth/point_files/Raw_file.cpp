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

Raw_file::Raw_file(Anatomy file) : m_file(std::move(file))
{
  std::size_t count = 0;
  for (Block& block : m_file.blocks) {
    block.first.bytes = &m_file.bytes;
    count += block.count;
  }
  for (std::size_t c = 0; c < 3; ++c) {
    m_changing.emplace_back(m_file.layout.coordinates()[c], c);
    if (m_file.layout.has_normals())
      m_changing.emplace_back(m_file.layout.normals()[c], c + 3);
  }
  std::sort(m_changing.begin(), m_changing.end());
  load(count, m_file.layout.has_normals());
  roles = m_file.layout.roles();
  roles_source = m_file.layout_source;
  for (const std::size_t p : m_file.layout.coordinates())
    if (is_integer(m_file.layout.properties()[p].type) && warnings.empty())
      warnings.push_back("coordinates are integers: points are rounded to them in this format");
}

/// Calls a function with a cursor for the records of each block, their number and the number of those
/// before them.
template <typename Function>
void Raw_file::for_each_block(const Function& f) const
{
  std::size_t before = 0;
  for (const Block& block : m_file.blocks) {
    if (m_file.encoding == Encoding::TEXT) {
      Text_cursor cursor(block.first, m_file.layout.properties(), m_file.style);
      f(cursor, block.count, before);
    }
    else {
      Binary_cursor cursor(block.first, m_file.layout.properties(),
                           m_file.encoding == Encoding::SWAPPED_BINARY);
      f(cursor, block.count, before);
    }
    before += block.count;
  }
}

template <typename Cursor>
const std::vector<Field>& Raw_file::next(Cursor& cursor, std::size_t i, std::size_t count) const
{
  const std::vector<Field>* fields = cursor.next();
  if (!fields)
    throw std::runtime_error("the file ends after " + std::to_string(i) + " of " +
                             std::to_string(count) + " points");
  return *fields;
}

template <typename Cursor>
void Raw_file::go_through(Cursor& cursor, std::size_t count, bool with_values,
                          const Visitor& visit) const
{
  const Layout& layout = m_file.layout;
  const std::vector<std::size_t> others =
      with_values ? layout.others() : std::vector<std::size_t>();
  Record record = {{0., 0., 0.}, {0., 0., 0.}, std::vector<Number>(others.size())};
  for (std::size_t i = 0; i < count; ++i) {
    const std::vector<Field>& fields = next(cursor, i, count);
    const auto value = [&](std::size_t p) {
      return cursor.value(fields[p], layout.properties()[p].type);
    };
    for (std::size_t c = 0; c < 3; ++c)
      record.coordinates[c] = value(layout.coordinates()[c]);
    for (std::size_t c = 0; layout.has_normals() && c < 3; ++c)
      record.normal[c] = value(layout.normals()[c]);
    if (layout.has_normals() && is_integer(layout.properties()[layout.normals()[0]].type)) {
      const double length = length_of_normal(cursor, fields);
      for (double& n : record.normal)
        n = length != 0. ? n / length : 0.;
    }
    for (std::size_t c = 0; c < others.size(); ++c)
      record.values[c] = cursor.exact_value(fields[others[c]], layout.properties()[others[c]].type);
    visit(record);
  }
}

/// How long the normal of a record is in the file: integers stand for a unit vector in some scale.
template <typename Cursor>
double Raw_file::length_of_normal(const Cursor& cursor, const std::vector<Field>& fields) const
{
  double n[3];
  for (std::size_t c = 0; c < 3; ++c) {
    const std::size_t p = m_file.layout.normals()[c];
    n[c] = cursor.value(fields[p], m_file.layout.properties()[p].type);
  }
  return std::hypot(n[0], n[1], n[2]);
}

/// Writes the bytes up to the end of a record, with the point and the normal that are now here.
template <typename Cursor>
void Raw_file::write_record(const Cursor& cursor, const std::vector<Field>& fields, std::size_t i,
                            Output& out) const
{
  const Layout& layout = m_file.layout;
  for (const auto& [p, c] : m_changing) {
    const Scalar type = layout.properties()[p].type;
    const double before = cursor.value(fields[p], type);
    double now = c < 3 ? points[i][int(c)] : normals[i][int(c) - 3];
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

void Raw_file::for_each_record(bool with_values, const Visitor& visit) const
{
  for_each_block([&](auto& cursor, std::size_t count, std::size_t) {
    go_through(cursor, count, with_values, visit);
  });
}

void Raw_file::write(const Target& target) const
{
  Output out = {m_file.bytes, target.out};
  if (!normals.empty() && !m_file.layout.has_normals()) {
    out.copy_up_to(m_file.normals_header.first);
    out.text += m_file.normals_header.second;
  }
  for_each_block([&](auto& cursor, std::size_t count, std::size_t before) {
    for (std::size_t i = 0; i < count; ++i)
      write_record(cursor, next(cursor, i, count), before + i, out);
  });
  out.flush();
  target.out.write(m_file.bytes.data() + out.done, std::streamsize(m_file.bytes.size() - out.done));
}

const Column_types& Raw_file::column_types() const
{
  if (!m_columns) {
    const std::vector<std::size_t> others = m_file.layout.others();
    m_columns.emplace(others.size());
    for_each_block([&](auto& cursor, std::size_t count, std::size_t) {
      for (std::size_t i = 0; i < count; ++i) {
        const std::vector<Field>& fields = next(cursor, i, count);
        for (std::size_t c = 0; c < others.size(); ++c) {
          const Field& field = fields[others[c]];
          m_columns->add(c, m_file.bytes.substr(field.begin, field.end - field.begin));
        }
      }
    });
  }
  return *m_columns;
}

std::vector<Property> Raw_file::columns() const
{
  std::vector<Property> columns;
  for (const std::size_t i : m_file.layout.others()) {
    Property column = m_file.layout.properties()[i];
    if (!m_file.has_types)
      column.type = column_types().type(columns.size());
    columns.push_back(column);
  }
  return columns;
}

std::vector<std::string> Raw_file::losses() const
{
  std::vector<std::string> losses = m_file.losses;
  const std::vector<Property> all = m_file.has_types ? std::vector<Property>() : columns();
  for (std::size_t c = 0; c < all.size(); ++c)
    if (column_types().loses_digits(c))
      losses.push_back("all digits of " + all[c].name);
  return losses;
}

} // namespace point_files
