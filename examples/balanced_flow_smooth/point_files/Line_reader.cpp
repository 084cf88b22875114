// SPDX-License-Identifier: GPL-3.0-or-later
#include "Line_reader.h"

#include "Scalar.h"

#include <algorithm>
#include <optional>
#include <stdexcept>

namespace point_files {

namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

} // namespace

bool Line_reader::next(Field& line)
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

void Line_reader::split(const Field& line, std::vector<Field>& words) const
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

double Line_reader::number(const Field& word) const
{
  const char* begin = m_place.bytes->data() + word.begin;
  const char* end = m_place.bytes->data() + word.end;
  const std::optional<double> number = from_text(begin, end);
  if (!number)
    fail("\"" + std::string(begin, end) + "\" is not a number");
  return *number;
}

void Line_reader::fail(const std::string& reason) const
{
  throw std::runtime_error("line " + std::to_string(m_place.line) + ": " + reason);
}

} // namespace point_files
