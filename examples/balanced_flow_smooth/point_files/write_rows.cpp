// SPDX-License-Identifier: GPL-3.0-or-later
#include "write_rows.h"

#include <algorithm>

namespace point_files {

void write_text_rows(std::ostream& out, const Point_file& file, char separator)
{
  const auto append = [separator](std::string& row, Scalar type, const Number& number) {
    if (!row.empty())
      row += separator;
    append_text(row, type, number);
  };
  write_rows(out, file, append, "\n");
}

std::string names_of_rows(const Point_file& file, char separator)
{
  std::string names;
  for (const std::string& name : default_names(3, !file.normals.empty()))
    names += (names.empty() ? "" : std::string(1, separator)) + name;
  for (const Property& column : file.columns())
    names += separator + column_name(column);
  return names;
}

std::string column_name(const Property& column)
{
  std::string name = (role_of(column.name).empty() ? "" : "other_") + column.name;
  std::replace_if(
      name.begin(), name.end(),
      [](unsigned char c) { return c <= ' ' || c == ',' || c == ';' || c == '"' || c == '#'; },
      '_');
  return name.empty() ? "_" : name;
}

} // namespace point_files
