// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_FILES_LINE_READER_H
#define POINT_FILES_LINE_READER_H

#include <cstddef>
#include <string>
#include <vector>

namespace point_files {

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
  bool next(Field& line);

  /// Cuts a line into words.
  void split(const Field& line, std::vector<Field>& words) const;

  std::string text(const Field& word) const
  {
    return m_place.bytes->substr(word.begin, word.end - word.begin);
  }

  /// Throws `std::runtime_error` if the word is none.
  double number(const Field& word) const;

  [[noreturn]] void fail(const std::string& reason) const;
};

} // namespace point_files

#endif // POINT_FILES_LINE_READER_H
