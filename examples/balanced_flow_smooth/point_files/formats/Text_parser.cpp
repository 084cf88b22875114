// SPDX-License-Identifier: GPL-3.0-or-later
#include "Text_parser.h"

#include "../write_rows.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace point_files {

void Normals_guess::add(const Line_reader& lines, const std::vector<Field>& words)
{
  double n[3];
  for (std::size_t c = 0; c < 3 && m_are_possible; ++c) {
    const char* bytes = lines.place().bytes->data();
    const auto number = words.size() < 6
                            ? std::nullopt
                            : from_text(bytes + words[c + 3].begin, bytes + words[c + 3].end);
    m_are_possible = number.has_value();
    n[c] = number.value_or(0.);
  }
  if (!m_are_possible)
    return;
  const double length = std::hypot(n[0], n[1], n[2]);
  const bool is_unit = std::abs(length - 1.) < .01;
  m_is_any_known = m_is_any_known || is_unit;
  m_are_possible = is_unit || length == 0. || std::isnan(length);
}

Text_parser::Text_parser(Bytes bytes, const Names& columns) : m_is_told_by_user(!columns.empty())
{
  m_file.bytes = std::move(bytes);
  m_head = read_text_head(m_file.bytes, columns);
  m_file.style.separator = m_head.separator;
  m_file.has_types = false;
}

Anatomy Text_parser::parse(Default_names names)
{
  Line_reader lines(Place{&m_file.bytes}, m_head.separator);
  m_file.blocks.push_back({lines.place(), 0});
  Field line;
  std::vector<Field> words;
  while (lines.next(line)) {
    lines.split(line, words);
    if (lines.place().line == m_head.header_line)
      m_file.blocks.back().first = lines.place();
    else if (words.size() == 1 && (m_count == 0 || m_announced))
      begin_block(lines, words[0]);
    else
      add_point(lines, words);
  }
  end_block();
  if (m_file.blocks.size() > 1)
    m_file.losses.push_back("the division into scans");
  set_layout(names);
  return std::move(m_file);
}

void Text_parser::begin_block(const Line_reader& lines, const Field& word)
{
  const double number = lines.number(word);
  end_block();
  m_announced = number;
  m_announcement = lines.place().line;
  if (m_file.blocks.back().count != 0)
    m_file.blocks.emplace_back();
  m_file.blocks.back() = {lines.place(), 0, {word}};
}

void Text_parser::end_block() const
{
  const std::size_t count = m_file.blocks.back().count;
  if (!m_announced || *m_announced == double(count))
    return;
  std::string announced;
  append_text(announced, Scalar::DOUBLE, *m_announced);
  throw std::runtime_error("line " + std::to_string(m_announcement) + " announces " + announced +
                           " points, but there are " + std::to_string(count));
}

void Text_parser::add_point(const Line_reader& lines, const std::vector<Field>& words)
{
  lines.check_columns(words, m_width);
  m_normals.add(lines, words);
  ++m_file.blocks.back().count;
  ++m_count;
}

/// The names of all columns, each used once
Text_parser::Names Text_parser::names_of_columns(Default_names default_names_of) const
{
  Names names = m_head.names;
  if (names.size() < m_width && !m_is_told_by_user) {
    const Names defaults = default_names_of(m_width);
    names.insert(names.end(), defaults.begin() + std::ptrdiff_t(names.size()), defaults.end());
  }
  if (names.size() > m_width)
    throw std::runtime_error(std::to_string(names.size()) + " names of columns, but there are " +
                             std::to_string(m_width) + " columns");
  names.resize(m_width);
  for (std::size_t i = 0; i < m_width; ++i) {
    const std::string role = role_of(names[i]);
    const auto end = names.begin() + std::ptrdiff_t(i);
    if (!role.empty())
      names[i] = role;
    else if (names[i].empty() || names[i] == "_")
      names[i] = "column_" + std::to_string(i + 1);
    else if (std::find(names.begin(), end, names[i]) != end)
      names[i] += "_" + std::to_string(i + 1);
  }
  return names;
}

void Text_parser::set_layout(Default_names default_names_of)
{
  if (m_count == 0)
    throw std::runtime_error("there are no points in it");
  m_file.layout = Layout(names_of_columns(default_names_of));
  m_file.layout_source = m_head.source;
  set_normals_header();
}

/// Finds out what names new normals: the line of names, or a new one, which is a comment.
void Text_parser::set_normals_header()
{
  const std::size_t last = m_file.layout.last_coordinate();
  auto& [place, text] = m_file.normals_header.emplace_back();
  const bool has_names = last < m_head.name_fields.size();
  const char separator = has_names ? m_head.name_separator : m_head.separator;
  for (const char* name : {"nx", "ny", "nz"})
    text += separator + std::string(name);
  if (has_names) {
    const Line_reader names(Place{&m_file.bytes}, separator);
    place = names.end_of_cell(m_head.name_fields[last]);
    return;
  }
  place = m_head.first_point;
  const std::string normals = std::move(text);
  text = "# ";
  const std::vector<Property>& columns = m_file.layout.properties();
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const bool has_role = !role_of(columns[i].name).empty();
    text += (i == 0 ? "" : std::string(1, separator)) +
            (has_role ? columns[i].name : column_name(columns[i])) + (i == last ? normals : "");
  }
  text += m_head.end_of_line;
}

std::vector<std::string> names_of_scan_columns(std::size_t width)
{
  std::vector<std::string> names = {"x", "y", "z"};
  if (width == 4 || width == 7)
    names.push_back("intensity");
  if (width == 6 || width == 7)
    names.insert(names.end(), {"red", "green", "blue"});
  return names.size() == width ? names : default_names(width, false);
}

} // namespace point_files
