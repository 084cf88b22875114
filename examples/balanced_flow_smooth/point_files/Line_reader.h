// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_FILES_LINE_READER_H
#define POINT_FILES_LINE_READER_H

#include "Bytes.h"
#include "Scalar.h"

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
  const Bytes* bytes;
  std::size_t at = 0;
  std::size_t line = 0; // of text: how many are before it
};

/// How text is cut into words
struct Text_style {
  char separator = ' ';       // of cells; a blank stands for blanks and tabs, as many as there are
  bool lines_may_end = false; // within a record
};

/// Reads lines of text and knows where it is. Lines end with LF, CR or both. Empty lines and comments
/// do not count: from # on, or lines that begin with //; between separators, # is one only at the
/// beginning of a line. A byte order mark is skipped.
class Line_reader {
  Place m_place;
  char m_separator;
  std::size_t m_line_feed = 0; // the next one, or the end of the file; not known up to this place

public:
  explicit Line_reader(const Place& place, char separator = ' ');

  const Place& place() const { return m_place; }

  /// Takes the next line, whatever is in it, without its end.
  /// \return whether there is one
  bool next_line(Field& line);

  /// \return whether there is a next line with something in it
  bool next(Field& line);

  /// Cuts a line into words, or into cells: without the blanks around them and without quotes.
  void split(const Field& line, std::vector<Field>& words) const;
  /// The same, behind other words
  void append_words(const Field& line, std::vector<Field>& words) const;

  /// Where the cell of a word ends, so that another one can come
  std::size_t end_of_cell(const Field& word) const;

  std::string text(const Field& word) const
  {
    return m_place.bytes->substr(word.begin, word.end - word.begin);
  }

  /// Throws `std::runtime_error` if the word is none.
  double number(const Field& word) const;
  /// The same with all digits of an integer
  Number exact_number(const Field& word) const;

  /// Throws `std::runtime_error` unless the words are a point with as many columns as those before.
  /// \param width the number of these columns; 0 for the first point, which tells it
  void check_columns(const std::vector<Field>& words, std::size_t& width) const;

  [[noreturn]] void fail(const std::string& reason) const;

private:
  bool is_blank(char c) const { return c == ' ' || (c == '\t' && m_separator != '\t'); }
  void strip(Field& line) const;
  Field next_cell(std::size_t& at, std::size_t end) const;
  [[noreturn]] void fail_to_read(const std::string& word) const;
};

/// How many bytes a byte order mark takes at the beginning of a file in UTF-8; 0 if there is none.
std::size_t size_of_mark(const Bytes& bytes);

/// The first word of a file, comments left out; empty if there is none
std::string first_word(const Bytes& bytes);

} // namespace point_files

#endif // POINT_FILES_LINE_READER_H
