// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_FILES_RECORD_CURSOR_H
#define POINT_FILES_RECORD_CURSOR_H

#include "Layout.h"
#include "Line_reader.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace point_files {

// Two ways through the records of a file, as text and as bytes: what tells them apart is here.

/// Goes through records of text.
class Text_cursor {
  Line_reader m_lines;
  const std::vector<Property>& m_properties;
  Text_style m_style;
  std::vector<Field> m_words, m_fields;
  bool m_has_lists;

public:
  Text_cursor(const Place& place, const std::vector<Property>& properties, const Text_style& style)
      : m_lines(place, style.separator), m_properties(properties), m_style(style),
        m_has_lists(std::any_of(properties.begin(), properties.end(),
                                [](const Property& p) { return p.count_type.has_value(); }))
  {}

  Place place() const { return m_lines.place(); }

  /// The fields of the next record, one for each property, or null at the end of the file
  const std::vector<Field>* next();

  double value(const Field& field, Scalar type) const
  {
    const double number = m_lines.number(field);
    const auto rounded = float(number); // as if it was read from bytes, unless it is too large
    return type == Scalar::FLOAT && std::isfinite(rounded) ? double(rounded) : number;
  }
  Number exact_value(const Field& field, Scalar) const { return m_lines.exact_number(field); }

  void append(std::string& out, Scalar type, const Number& number) const
  {
    append_text(out, type, number);
  }
  void append_between(std::string& out) const { out += m_style.separator; }

  /// where a new field can come after this one
  std::size_t end_of(const Field& field) const { return m_lines.end_of_cell(field); }

private:
  std::size_t join_lists();
};

/// Goes through records that are bytes one after the other.
class Binary_cursor {
  Place m_place;
  const std::vector<Property>& m_properties;
  std::vector<Field> m_fields;
  bool m_swapped;

public:
  Binary_cursor(const Place& place, const std::vector<Property>& properties, bool swapped)
      : m_place(place), m_properties(properties), m_fields(properties.size()), m_swapped(swapped)
  {}

  Place place() const { return m_place; }

  /// the same, of bytes
  const std::vector<Field>* next();

  double value(const Field& field, Scalar type) const
  {
    return from_bytes(type, m_place.bytes->data() + field.begin, m_swapped);
  }
  Number exact_value(const Field& field, Scalar type) const
  {
    return number_from_bytes(type, m_place.bytes->data() + field.begin, m_swapped);
  }

  void append(std::string& out, Scalar type, const Number& number) const
  {
    append_bytes(out, type, number, m_swapped);
  }
  static void append_between(std::string&) {}
  static std::size_t end_of(const Field& field) { return field.end; }

  /// Where the value of a property ends that begins at `at`; nothing if it is not complete.
  static std::optional<std::size_t> find_end(const Bytes& bytes, const Property& property,
                                             std::size_t at, bool swapped);
};

} // namespace point_files

#endif // POINT_FILES_RECORD_CURSOR_H
