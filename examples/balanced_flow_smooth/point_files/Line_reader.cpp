// SPDX-License-Identifier: GPL-3.0-or-later
#include "Line_reader.h"

#include <algorithm>
#include <optional>
#include <stdexcept>

namespace point_files {

std::size_t size_of_mark(const Bytes& bytes)
{
  return bytes.compare(0, 3, "\xEF\xBB\xBF") == 0 ? 3 : 0;
}

Line_reader::Line_reader(const Place& place, char separator)
    : m_place(place), m_separator(separator)
{
  if (m_place.at == 0)
    m_place.at = size_of_mark(*m_place.bytes);
}

bool Line_reader::next_line(Field& line)
{
  const Bytes& bytes = *m_place.bytes;
  if (m_place.at >= bytes.size())
    return false;
  if (m_line_feed <= m_place.at) // searched once for many lines that end with CR
    m_line_feed = (std::min)(bytes.find('\n', m_place.at), bytes.size());
  const auto begin = bytes.begin() + std::ptrdiff_t(m_place.at);
  const auto end = std::find(begin, bytes.begin() + std::ptrdiff_t(m_line_feed), '\r');
  line = {m_place.at, std::size_t(end - bytes.begin())};
  m_place.at = (std::min)(line.end + 1, bytes.size());
  if (line.end < m_line_feed && m_place.at == m_line_feed) // CR and LF
    m_place.at = (std::min)(m_line_feed + 1, bytes.size());
  ++m_place.line;
  bytes.pass(m_place.at);
  return true;
}

/// Takes comments and blanks away.
void Line_reader::strip(Field& line) const
{
  const Bytes& bytes = *m_place.bytes;
  while (line.begin != line.end && is_blank(bytes[line.begin]))
    ++line.begin;
  if (m_separator == ' ') {
    const auto begin = bytes.begin() + std::ptrdiff_t(line.begin);
    const auto end = bytes.begin() + std::ptrdiff_t(line.end);
    line.end = std::size_t(std::find(begin, end, '#') - bytes.begin());
  }
  else if (line.begin != line.end && bytes[line.begin] == '#')
    line.end = line.begin;
  if (line.end - line.begin > 1 && bytes.compare(line.begin, 2, "//") == 0)
    line.end = line.begin;
}

bool Line_reader::next(Field& line)
{
  while (next_line(line)) {
    strip(line);
    const auto is_empty = [this](char c) { return is_blank(c) || c == m_separator; };
    if (!std::all_of(m_place.bytes->begin() + std::ptrdiff_t(line.begin),
                     m_place.bytes->begin() + std::ptrdiff_t(line.end), is_empty))
      return true;
  }
  return false;
}

void Line_reader::split(const Field& line, std::vector<Field>& words) const
{
  words.clear();
  append_words(line, words);
}

void Line_reader::append_words(const Field& line, std::vector<Field>& words) const
{
  std::size_t at = line.begin;
  if (m_separator != ' ') {
    do
      words.push_back(next_cell(at, line.end));
    while (at <= line.end);
    return;
  }
  while (at != line.end) {
    Field word = {at, at};
    while (word.end != line.end && !is_blank((*m_place.bytes)[word.end]))
      ++word.end;
    words.push_back(word);
    at = word.end;
    while (at != line.end && is_blank((*m_place.bytes)[at]))
      ++at;
  }
}

/// Takes the cell at a place.
/// \param at goes behind the separator after it, or behind the end of the line
Field Line_reader::next_cell(std::size_t& at, std::size_t end) const
{
  const Bytes& bytes = *m_place.bytes;
  while (at != end && is_blank(bytes[at]))
    ++at;
  Field cell = {at, at};
  if (at != end && bytes[at] == '"') {
    cell.begin = ++at;
    while (at != end && (bytes[at] != '"' || (at + 1 != end && bytes[at + 1] == '"')))
      at += bytes[at] == '"' ? 2 : 1; // two quotes stand for one
    cell.end = at;
    while (at != end && bytes[at] != m_separator)
      ++at;
  }
  else {
    while (at != end && bytes[at] != m_separator)
      ++at;
    cell.end = at;
    while (cell.end != cell.begin && is_blank(bytes[cell.end - 1]))
      --cell.end;
  }
  ++at;
  return cell;
}

std::size_t Line_reader::end_of_cell(const Field& word) const
{
  if (m_separator == ' ')
    return word.end;
  const char ends[] = {m_separator, '\r', '\n', '\0'};
  return (std::min)(m_place.bytes->find_first_of(ends, word.end), m_place.bytes->size());
}

double Line_reader::number(const Field& word) const
{
  const char* bytes = m_place.bytes->data();
  const std::optional<double> number = from_text(bytes + word.begin, bytes + word.end);
  return number ? *number : (fail_to_read(text(word)), 0.);
}

Number Line_reader::exact_number(const Field& word) const
{
  const char* bytes = m_place.bytes->data();
  const std::optional<Number> number = number_from_text(bytes + word.begin, bytes + word.end);
  return number ? *number : (fail_to_read(text(word)), 0.);
}

void Line_reader::fail_to_read(const std::string& word) const
{
  std::string with_point = word;
  std::replace(with_point.begin(), with_point.end(), ',', '.');
  const char* begin = with_point.data();
  const bool has_comma = with_point != word && from_text(begin, begin + with_point.size());
  fail("\"" + word + "\" is not a number" + (has_comma ? ": decimals need a point" : ""));
}

void Line_reader::check_columns(const std::vector<Field>& words, std::size_t& width) const
{
  if (words.size() < 3) {
    for (const Field& word : words)
      number(word); // may tell more
    fail("a point has three coordinates");
  }
  if (width != 0 && words.size() != width)
    fail(std::to_string(words.size()) + " columns, but " + std::to_string(width) + " before");
  width = words.size();
}

void Line_reader::fail(const std::string& reason) const
{
  throw std::runtime_error("line " + std::to_string(m_place.line) + ": " + reason);
}

std::string first_word(const Bytes& bytes)
{
  Line_reader lines(Place{&bytes});
  Field line;
  std::vector<Field> words;
  if (!lines.next(line))
    return "";
  lines.split(line, words);
  return lines.text(words[0]);
}

} // namespace point_files
