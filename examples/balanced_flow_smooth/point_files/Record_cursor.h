// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_FILES_RECORD_CURSOR_H
#define POINT_FILES_RECORD_CURSOR_H

#include "Layout.h"
#include "Line_reader.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace point_files {

// Two ways through the records of a file, as text and as bytes: what tells them apart is here.

/// Goes through records that are lines of numbers.
class Text_cursor {
  Line_reader m_lines;
  const Layout& m_layout;
  std::vector<Field> m_words, m_fields;
  bool m_has_lists;

public:
  Text_cursor(const Place& place, const Layout& layout, bool)
      : m_lines(place), m_layout(layout),
        m_has_lists(std::any_of(layout.properties().begin(), layout.properties().end(),
                                [](const Property& p) { return p.count_type.has_value(); }))
  {}

  Place place() const { return m_lines.place(); }

  /// The fields of the next record, one for each property, or null at the end of the file
  const std::vector<Field>* next();

  double value(const Field& field, Scalar) const { return m_lines.number(field); }

  static void append(std::string& out, Scalar type, double number, bool)
  {
    append_text(out, type, number);
  }
  static void append_between(std::string& out) { out += ' '; }

private:
  /// Makes one field of the words of each list.
  void join_lists();
};

/// Goes through records that are bytes one after the other.
class Binary_cursor {
  Place m_place;
  const Layout& m_layout;
  std::vector<Field> m_fields;
  bool m_swapped;

public:
  Binary_cursor(const Place& place, const Layout& layout, bool swapped)
      : m_place(place), m_layout(layout), m_fields(layout.properties().size()), m_swapped(swapped)
  {}

  Place place() const { return m_place; }

  /// the same, of bytes
  const std::vector<Field>* next();

  double value(const Field& field, Scalar type) const
  {
    return from_bytes(type, m_place.bytes->data() + field.begin, m_swapped);
  }

  static void append(std::string& out, Scalar type, double number, bool swapped)
  {
    append_bytes(out, type, number, swapped);
  }
  static void append_between(std::string&) {}

  /// Where the value of a property ends that begins at `at`; nothing if it is not complete.
  static std::optional<std::size_t> find_end(const std::string& bytes, const Property& property,
                                             std::size_t at, bool swapped);
};

} // namespace point_files

#endif // POINT_FILES_RECORD_CURSOR_H
