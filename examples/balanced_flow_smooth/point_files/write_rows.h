// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_FILES_WRITE_ROWS_H
#define POINT_FILES_WRITE_ROWS_H

#include "Point_file.h"

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace point_files {

// From one format to another: points, normals and whatever else are numbers of points.

/// Goes through the points that are to be written, with the number of each and all of its values.
template <typename Visit>
void for_each_record_to_write(const Point_file& file, const Visit& visit)
{
  std::size_t i = 0;
  file.for_each_record(true, [&](const Record& record) {
    if (!file.is_dropped(i))
      visit(i, record);
    ++i;
  });
}

/// Writes one line or record for each point: coordinates, normal if there are any, columns.
/// \param append adds a number of a type to a text
template <typename Append>
void write_rows(std::ostream& out, const Point_file& file, const Append& append,
                const std::string& end_of_row)
{
  const std::vector<Property> columns = file.columns();
  const Scalar type = file.coordinate_type();
  std::string row;
  for_each_record_to_write(file, [&](std::size_t i, const Record& record) {
    row.clear();
    for (int c = 0; c < 3; ++c)
      append(row, type, file.points[i][c]);
    for (int c = 0; c < 3 && !file.normals.empty(); ++c)
      append(row, type, file.normals[i][c]);
    for (std::size_t c = 0; c < columns.size(); ++c)
      append(row, columns[c].type, record.values[c]);
    row += end_of_row;
    out.write(row.data(), std::streamsize(row.size()));
  });
}

/// Lines of text with a separator between the numbers
void write_text_rows(std::ostream& out, const Point_file& file, char separator = ' ');

/// What is in these lines, for the line before them
std::string names_of_rows(const Point_file& file, char separator = ' ');

/// The name of a column, without what ends words in any of our formats, and none of those that
/// coordinates and normals have
std::string column_name(const Property& column);

} // namespace point_files

#endif // POINT_FILES_WRITE_ROWS_H
