// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_SMOOTH_RECORD_CURSOR_H
#define BALANCED_FLOW_SMOOTH_RECORD_CURSOR_H

#include "Layout.h"

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

// Two ways through the records of a file, as text and as bytes: what tells them apart is here.

/// Where the value of a property is among the bytes of the file
struct Field {
  std::size_t begin, end;
};

/// The content of a file, and a place in it
struct Place {
  const std::string* bytes;
  std::size_t at = 0;
  std::size_t line = 0; // of text: how many are before it
};

/// Reads lines of text and knows where it is. Empty lines and comments, from # or // on, do not count.
class Line_reader {
  Place m_place;

public:
  explicit Line_reader(const Place& place) : m_place(place) {}

  const Place& place() const { return m_place; }

  /// \return whether there is a next line with something in it
  bool next(Field& line)
  {
    const std::string& bytes = *m_place.bytes;
    while (m_place.at < bytes.size()) {
      line.begin = m_place.at;
      line.end = (std::min)(bytes.find('\n', m_place.at), bytes.size());
      m_place.at = (std::min)(line.end + 1, bytes.size());
      ++m_place.line;
      const auto first = bytes.begin() + std::ptrdiff_t(line.begin);
      const auto last = bytes.begin() + std::ptrdiff_t(line.end);
      line.end -= std::size_t(last - std::find(first, last, '#'));
      while (line.begin != line.end && is_blank(bytes[line.begin]))
        ++line.begin;
      if (line.begin != line.end && bytes.compare(line.begin, 2, "//") != 0)
        return true;
    }
    return false;
  }

  [[noreturn]] void fail(const std::string& reason) const
  {
    throw std::runtime_error("line " + std::to_string(m_place.line) + ": " + reason);
  }

  /// cuts a line into words
  void split(const Field& line, std::vector<Field>& words) const
  {
    words.clear();
    for (std::size_t at = line.begin; at != line.end;) {
      Field word = {at, at};
      while (word.end != line.end && !is_blank((*m_place.bytes)[word.end]))
        ++word.end;
      words.push_back(word);
      at = word.end;
      while (at != line.end && is_blank((*m_place.bytes)[at]))
        ++at;
    }
  }

  double number(const Field& word) const
  {
    const char* begin = m_place.bytes->data() + word.begin;
    const char* end = m_place.bytes->data() + word.end;
    const std::optional<double> number = from_text(begin, end);
    if (!number)
      fail("\"" + std::string(begin, end) + "\" is not a number");
    return *number;
  }

private:
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }
};

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
  const std::vector<Field>* next()
  {
    Field line;
    if (!m_lines.next(line))
      return nullptr;
    m_lines.split(line, m_words);
    if (m_has_lists)
      join_lists();
    const std::vector<Field>& fields = m_has_lists ? m_fields : m_words;
    if (fields.size() != m_layout.properties().size())
      m_lines.fail(std::to_string(fields.size()) + " columns, but " +
                   std::to_string(m_layout.properties().size()) + " are expected");
    return &fields;
  }

  double value(const Field& field, Scalar) const { return m_lines.number(field); }

  static void append(std::string& out, Scalar type, double number, bool)
  {
    append_text(out, type, number);
  }
  static void append_between(std::string& out) { out += ' '; }

private:
  /// Makes one field of the words of each list.
  void join_lists()
  {
    m_fields.clear();
    std::size_t at = 0;
    for (const Property& property : m_layout.properties()) {
      if (at == m_words.size())
        return;
      Field field = m_words[at++];
      if (property.count_type) {
        const double count = m_lines.number(field);
        if (!(count >= 0. && count <= double(m_words.size() - at)))
          m_lines.fail("the list " + property.name + " is not complete");
        at += std::size_t(count);
        field.end = m_words[at - 1].end;
      }
      m_fields.push_back(field);
    }
    while (at != m_words.size()) // too many: counted by the caller
      m_fields.push_back(m_words[at++]);
  }
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

  const std::vector<Field>* next()
  {
    std::size_t at = m_place.at;
    for (std::size_t i = 0; i < m_fields.size(); ++i) {
      const std::optional<std::size_t> end =
          find_end(*m_place.bytes, m_layout.properties()[i], at, m_swapped);
      if (!end)
        return nullptr;
      m_fields[i] = {at, *end};
      at = *end;
    }
    m_place.at = at;
    return &m_fields;
  }

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
                                             std::size_t at, bool swapped)
  {
    double count = 1.;
    if (property.count_type) {
      const std::size_t size = size_of(*property.count_type);
      if (bytes.size() - at < size)
        return std::nullopt;
      count = from_bytes(*property.count_type, bytes.data() + at, swapped);
      at += size;
    }
    const std::size_t size = size_of(property.type);
    if (!(count >= 0. && count <= double((bytes.size() - at) / size)))
      return std::nullopt;
    return at + std::size_t(count) * size;
  }
};

#endif // BALANCED_FLOW_SMOOTH_RECORD_CURSOR_H
