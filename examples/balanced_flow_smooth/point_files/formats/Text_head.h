// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_FILES_TEXT_HEAD_H
#define POINT_FILES_TEXT_HEAD_H

#include "../Line_reader.h"

#include <cstddef>
#include <string>
#include <vector>

namespace point_files {

/// What is before the first point of text, and tells how the points are to be read
struct Text_head {
  char separator = ' ';           // of the cells of points
  std::size_t header_line = 0;    // the number of the line of names that is no comment; 0: none
  std::vector<std::string> names; // of columns, as far as something tells them
  std::string source;             // what tells them, for people; empty if nothing does

  std::size_t first_point = 0;    // where its line begins
  std::string end_of_line = "\n"; // that of this line

  // where the names are in the file, if they are there
  std::vector<Field> name_fields;
  char name_separator = ' ';
};

/// Finds out what is before the first point.
/// \param columns names that the user gives, which overrule those in the file
///
/// Throws `std::runtime_error` if a line of names does not tell where the coordinates are.
Text_head read_text_head(const Bytes& bytes, const std::vector<std::string>& columns);

} // namespace point_files

#endif // POINT_FILES_TEXT_HEAD_H
