// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_FILES_TEXT_PARSER_H
#define POINT_FILES_TEXT_PARSER_H

#include "../Raw_file.h"
#include "Text_head.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace point_files {

/// Finds out whether columns 4 to 6 look like normals: unit vectors, and some that are not known.
class Normals_guess {
  bool m_are_possible = true, m_is_any_known = false;

public:
  void add(const Line_reader& lines, const std::vector<Field>& words);
  bool operator()() const { return m_are_possible && m_is_any_known; }
};

/// Finds the points of a text, in blocks that may begin with their number.
class Text_parser {
  Anatomy m_file;
  Text_head m_head;
  bool m_is_told_by_user; // what columns are
  std::size_t m_width = 0, m_count = 0;
  std::optional<double> m_announced; // by a line before the block
  std::size_t m_announcement = 0;    // the number of that line
  Normals_guess m_normals;

public:
  typedef std::vector<std::string> Names;
  /// The names of so many columns
  typedef Names (*Default_names)(std::size_t width);

  /// \param columns see `read_text_head()`
  Text_parser(Bytes bytes, const Names& columns);

  /// Throws `std::runtime_error` if lines differ in their number of columns, or blocks from their
  /// announced size.
  /// \param names for a file that tells none
  Anatomy parse(Default_names names);

  /// Whether there seem to be normals, but nothing says so
  bool has_unnamed_normals() const { return m_head.source.empty() && m_normals(); }

private:
  void begin_block(const Line_reader& lines, const Field& word);
  void end_block() const;
  void add_point(const Line_reader& lines, const std::vector<Field>& words);
  Names names_of_columns(Default_names names) const;
  void set_normals_header();
  void set_layout(Default_names default_names_of);
};

/// The names of the columns of Leica's formats: an intensity, a color, or both; else `default_names()`
std::vector<std::string> names_of_scan_columns(std::size_t width);

} // namespace point_files

#endif // POINT_FILES_TEXT_PARSER_H
