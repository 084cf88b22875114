// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_SMOOTH_RAW_FILE_H
#define BALANCED_FLOW_SMOOTH_RAW_FILE_H

#include "Point_file.h"
#include "Record_cursor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

enum class Encoding { TEXT, BINARY, SWAPPED_BINARY };

/// What the readers of the formats find out about the bytes of a file
struct Anatomy {
  std::string bytes; // all of the file
  Encoding encoding = Encoding::TEXT;
  Layout layout;
  Place first; // where the records of the points begin
  std::size_t count = 0;
  std::pair<std::size_t, std::string> normals_header; // what announces new normals, and where
  std::vector<std::string> losses;                    // what other formats can not take
};

/// A file that is kept as its bytes, of which only the numbers that change are replaced.
class Raw_file : public Point_file {
  Anatomy m_file;

public:
  explicit Raw_file(Anatomy file) : m_file(std::move(file))
  {
    m_file.first.bytes = &m_file.bytes;
    load(m_file.count, m_file.layout.has_normals());
  }
  Raw_file(const Raw_file&) = delete; // the place of the first record looks at the bytes
  Raw_file& operator=(const Raw_file&) = delete;

  void for_each_record(bool with_values, const Visitor& visit) const override
  {
    with_cursor([&](auto cursor) { go_through(cursor, with_values, visit); });
  }

  void write(const Target& target) const override
  {
    with_cursor([&](auto cursor) { write_with(cursor, target.out); });
  }

  std::vector<Property> columns() const override
  {
    std::vector<Property> columns;
    for (const std::size_t i : m_file.layout.others())
      columns.push_back(m_file.layout.properties()[i]);
    return columns;
  }

  std::vector<std::string> losses() const override { return m_file.losses; }
  Scalar coordinate_type() const override { return m_file.layout.coordinate_type(); }

private:
  template <typename Function>
  void with_cursor(const Function& f) const
  {
    if (m_file.encoding == Encoding::TEXT)
      f(Text_cursor(m_file.first, m_file.layout, false));
    else
      f(Binary_cursor(m_file.first, m_file.layout, m_file.encoding == Encoding::SWAPPED_BINARY));
  }

  template <typename Cursor>
  const std::vector<Field>& next(Cursor& cursor, std::size_t i) const
  {
    const std::vector<Field>* fields = cursor.next();
    if (!fields)
      throw std::runtime_error("the file ends after " + std::to_string(i) + " of " +
                               std::to_string(m_file.count) + " points");
    return *fields;
  }

  template <typename Cursor>
  void go_through(Cursor& cursor, bool with_values, const Visitor& visit) const
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

  template <typename Cursor>
  void write_with(Cursor& cursor, std::ostream& out) const
  {
    const Layout& layout = m_file.layout;
    const bool swapped = m_file.encoding == Encoding::SWAPPED_BINARY;
    const bool new_normals = !normals.empty() && !layout.has_normals();
    // what may change: the properties in the order of the record, with their coordinates
    std::vector<std::pair<std::size_t, std::size_t>> places;
    for (std::size_t c = 0; c < 3; ++c) {
      places.emplace_back(layout.coordinates()[c], c);
      if (layout.has_normals())
        places.emplace_back(layout.normals()[c], c + 3);
    }
    std::sort(places.begin(), places.end());

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
};

#endif // BALANCED_FLOW_SMOOTH_RAW_FILE_H
