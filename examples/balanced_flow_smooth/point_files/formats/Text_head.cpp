// SPDX-License-Identifier: GPL-3.0-or-later
#include "Text_head.h"

#include "../Layout.h"

#include <algorithm>
#include <optional>
#include <stdexcept>

namespace point_files {

namespace {

struct Line {
  Field field = {0, 0};
  std::size_t number = 0; // 0: there is no such line
};

/// The lines that matter before the second point
struct First_lines {
  std::vector<Line> comments; // without what marks them as such
  Line header, point;
};

const std::string separators = ";,\t ";

bool is_number(const std::string& word)
{
  return from_text(word.data(), word.data() + word.size()).has_value();
}

/// Whether each of three roles is in it so many times
bool has_each(const std::vector<std::string>& names, const std::vector<std::string>& roles,
              std::ptrdiff_t times)
{
  return std::all_of(roles.begin(), roles.end(), [&](const std::string& role) {
    const auto is_it = [&](const std::string& name) { return role_of(name) == role; };
    return std::count_if(names.begin(), names.end(), is_it) == times;
  });
}

bool has_coordinates(const std::vector<std::string>& names)
{
  return has_each(names, {"x", "y", "z"}, 1);
}

/// Whether there are normals or nothing of them
bool has_whole_normals(const std::vector<std::string>& names)
{
  return has_each(names, {"nx", "ny", "nz"}, 0) || has_each(names, {"nx", "ny", "nz"}, 1);
}

/// The words between separators of any kind, without quotes
std::vector<std::string> words_of(const std::string& line)
{
  const std::string ends = separators + '"';
  std::vector<std::string> words;
  for (std::size_t at = line.find_first_not_of(ends); at != std::string::npos;) {
    const std::size_t end = line.find_first_of(ends, at);
    words.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(ends, end);
  }
  return words;
}

First_lines find_first_lines(const Bytes& bytes)
{
  First_lines found;
  Line_reader lines(Place{&bytes});
  Field field;
  while (lines.next_line(field)) {
    const std::string text = lines.text(field);
    const std::vector<std::string> words = words_of(text);
    if (words.empty())
      continue;
    const std::size_t begin = text.find_first_not_of(" \t");
    if (text[begin] == '#' || text.compare(begin, 2, "//") == 0) {
      const std::size_t names = text.find_first_not_of("#/ \t", begin);
      if (names != std::string::npos)
        found.comments.push_back({{field.begin + names, field.end}, lines.place().line});
      continue;
    }
    if (words.size() == 1) // the number of points
      continue;
    const bool has_numbers = std::any_of(words.begin(), words.end(), is_number);
    const bool has_names = (words.size() > 2 && !has_numbers) || has_coordinates(words);
    Line& line = has_names && found.header.number == 0 ? found.header : found.point;
    line = {field, lines.place().line};
    if (&line == &found.point)
      break;
  }
  return found;
}

/// The cells of a line
struct Cells {
  std::vector<Field> fields;
  std::vector<std::string> texts;

  Cells(const Bytes& bytes, const Line& line, char separator)
  {
    const Line_reader reader(Place{&bytes, line.field.begin}, separator);
    Field field = line.field;
    if (separator == ' ') // blanks at the beginning are none between words
      while (field.begin != field.end && separators.find(bytes[field.begin], 2) != separators.npos)
        ++field.begin;
    reader.split(field, fields);
    for (const Field& cell : fields)
      texts.push_back(reader.text(cell));
  }
};

/// Those that split the header into names come first.
std::string separators_by_header(const Bytes& bytes, const Line& header)
{
  std::string sorted = separators;
  if (header.number != 0)
    std::stable_partition(sorted.begin(), sorted.end(), [&](char separator) {
      return has_coordinates(Cells(bytes, header, separator).texts);
    });
  return sorted;
}

/// The separator that makes numbers of the first point
char find_separator(const Bytes& bytes, const Line& header, const Line& point)
{
  for (const char separator : separators_by_header(bytes, header)) {
    const std::vector<std::string> cells = Cells(bytes, point, separator).texts;
    const bool is_mixed =
        separator == '\t' && // with blanks: then both are the same
        bytes.substr(point.field.begin, point.field.end - point.field.begin).find(' ') !=
            std::string::npos;
    if (!is_mixed && std::count_if(cells.begin(), cells.end(), is_number) >= 3)
      return separator;
  }
  return ' ';
}

/// Takes the names from a line.
/// \return whether x, y and z are among them
bool take_names(const Bytes& bytes, const Line& line, Text_head& head)
{
  for (const char separator : head.separator + separators) {
    Cells cells(bytes, line, separator);
    if (!has_coordinates(cells.texts))
      continue;
    head.names = std::move(cells.texts);
    head.name_fields = std::move(cells.fields);
    head.name_separator = separator;
    return true;
  }
  return false;
}

/// How many cells the first point has; those that are empty at its end do not count.
std::size_t width_of(const Bytes& bytes, const Line& point, char separator)
{
  std::vector<std::string> cells = Cells(bytes, point, separator).texts;
  while (!cells.empty() && cells.back().empty())
    cells.pop_back();
  return cells.size();
}

void take_header(const Bytes& bytes, const First_lines& lines, std::size_t width, Text_head& head)
{
  const std::string where = "line " + std::to_string(lines.header.number);
  if (!take_names(bytes, lines.header, head))
    throw std::runtime_error(
        where + ": \"" +
        words_of(bytes.substr(lines.header.field.begin,
                              lines.header.field.end - lines.header.field.begin))[0] +
        "\" is not a number, and as names of columns x, y and z are missing (--columns tells "
        "them)");
  if (lines.point.number != 0 && head.names.size() < width)
    throw std::runtime_error(where + ": " + std::to_string(head.names.size()) +
                             " names, but the next line has " + std::to_string(width) +
                             " columns (--columns tells them)");
  head.source = "the header in " + where;
}

void take_comment(const Bytes& bytes, const First_lines& lines, std::size_t width, Text_head& head)
{
  for (auto comment = lines.comments.rbegin(); comment != lines.comments.rend(); ++comment) {
    Text_head with_names = head;
    if (!take_names(bytes, *comment, with_names))
      continue;
    const std::vector<std::string>& names = with_names.names;
    const bool is_beginning = names.size() < width && role_of(names[0]) == "x" &&
                              role_of(names[1]) == "y" && role_of(names[2]) == "z";
    if ((names.size() != width && !is_beginning) || !has_whole_normals(names)) // some other text
      continue;
    head = with_names;
    head.source = "the comment in line " + std::to_string(comment->number);
    return;
  }
}

} // namespace

Text_head read_text_head(const Bytes& bytes, const std::vector<std::string>& columns)
{
  const First_lines lines = find_first_lines(bytes);
  Text_head head;
  head.header_line = lines.header.number;
  std::size_t width = 0;
  if (lines.point.number != 0) {
    head.separator = find_separator(bytes, lines.header, lines.point);
    width = width_of(bytes, lines.point, head.separator);
    head.first_point = lines.point.field.begin;
    const std::size_t end = lines.point.field.end;
    if (end < bytes.size() && bytes[end] == '\r')
      head.end_of_line = bytes.compare(end, 2, "\r\n") == 0 ? "\r\n" : "\r";
  }
  if (lines.header.number == 0)
    take_comment(bytes, lines, width, head);
  else if (columns.empty())
    take_header(bytes, lines, width, head);
  else
    take_names(bytes, lines.header, head);
  if (!columns.empty()) {
    head.names = columns;
    head.source = "--columns";
  }
  return head;
}

} // namespace point_files
