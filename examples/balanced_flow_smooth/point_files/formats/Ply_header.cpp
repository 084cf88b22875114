// SPDX-License-Identifier: GPL-3.0-or-later
#include "Ply_header.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <sstream>
#include <stdexcept>

namespace point_files {

bool Ply_element::has_lists() const
{
  return std::any_of(properties.begin(), properties.end(),
                     [](const Property& p) { return p.count_type.has_value(); });
}

std::size_t Ply_element::fixed_size() const
{
  std::size_t size = 0;
  for (const Property& property : properties)
    size += size_of(property.type);
  return size;
}

Ply_header::Ply_header(const Bytes& bytes) : end(size_of_mark(bytes))
{
  bool has_format = false;
  // bytes behind the header may look like the second half of a line end, so the first line decides
  const std::size_t first_end = bytes.find_first_of("\r\n", end);
  if (first_end != std::string::npos && bytes[first_end] == '\r' &&
      bytes.compare(first_end, 2, "\r\n") != 0)
    end_of_line = "\r";
  for (;;) {
    const std::size_t line_end = bytes.find(end_of_line.back(), end);
    if (line_end == std::string::npos)
      throw std::runtime_error("this is not a complete PLY file");
    std::string line = bytes.substr(end, line_end - end), keyword;
    const std::size_t line_begin = end;
    end = line_end + 1;
    ++number_of_lines;
    if (!line.empty() && line.back() == '\r') {
      end_of_line = "\r\n";
      line.pop_back();
    }
    std::istringstream words(line);
    words >> keyword;
    if ((number_of_lines == 1) != (keyword == "ply"))
      throw std::runtime_error("this is not a PLY file");
    if (keyword == "end_header")
      break;
    if (keyword == "format") {
      read_format(line, words);
      has_format = true;
    }
    else if (keyword == "element")
      read_element(line, line_begin, bytes.size());
    else if (keyword == "property")
      read_property(line, words);
    else if (keyword != "ply" && keyword != "comment" && keyword != "obj_info" && !keyword.empty())
      throw std::runtime_error("\"" + line + "\" is not known in the header of a PLY file");
  }
  if (!has_format)
    throw std::runtime_error("the header of the PLY file tells no format");
}

void Ply_header::read_format(const std::string& line, std::istream& words)
{
  std::string name;
  words >> name;
  if (name == "ascii")
    encoding = Encoding::TEXT;
  else if (name == "binary_little_endian")
    encoding = is_little_endian() ? Encoding::BINARY : Encoding::SWAPPED_BINARY;
  else if (name == "binary_big_endian")
    encoding = is_little_endian() ? Encoding::SWAPPED_BINARY : Encoding::BINARY;
  else
    throw std::runtime_error("the format in \"" + line + "\" is not known");
}

void Ply_header::read_element(const std::string& line, std::size_t line_begin,
                              std::size_t file_size)
{
  Ply_element element;
  std::istringstream words(line);
  std::string keyword, count;
  words >> keyword >> element.name >> count;
  const char *begin = count.data(), *count_end = begin + count.size();
  const auto parsed = std::from_chars(begin, count_end, element.count);
  if (count.empty() || count.find_first_not_of("0123456789") != std::string::npos)
    throw std::runtime_error("there is no number of elements in \"" + line + "\"");
  if (parsed.ec != std::errc() || element.count > file_size)
    throw std::runtime_error("the file is too short for " + count +
                             (element.has_points() ? " points" : " times " + element.name));
  std::size_t at = line.find(keyword) + keyword.size();
  at = line.find(count, line.find(element.name, at) + element.name.size()) + line_begin;
  element.count_field = {at, at + count.size()};
  elements.push_back(element);
}

void Ply_header::read_property(const std::string& line, std::istream& words)
{
  if (elements.empty())
    throw std::runtime_error("\"" + line + "\" comes before any element");
  std::string type, count_type, name;
  words >> type;
  const bool is_list = type == "list";
  if (is_list)
    words >> count_type >> type;
  words >> name;
  const std::optional<Scalar> number = find_scalar(type), count = find_scalar(count_type);
  if (!number || (is_list && !(count && is_integer(*count))))
    throw std::runtime_error("the type in \"" + line + "\" is not known");
  elements.back().properties.emplace_back(name, *number, count);
  elements.back().property_ends.push_back(end);
}

} // namespace point_files
