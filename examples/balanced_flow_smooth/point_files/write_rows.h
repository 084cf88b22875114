// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_SMOOTH_CONVERT_H
#define BALANCED_FLOW_SMOOTH_CONVERT_H

#include "Point_file.h"

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

// From one format to another: points, normals and whatever else are numbers of points.

/// Writes one line or record for each point: coordinates, normal if there are any, columns.
/// \param append adds a number of a type to a text
template <typename Append>
void write_rows(std::ostream& out, const Point_file& file, const Append& append,
                const std::string& end_of_row)
{
  const std::vector<Property> columns = file.columns();
  const Scalar type = file.coordinate_type();
  std::string row;
  std::size_t i = 0;
  file.for_each_record(true, [&](const Record& record) {
    row.clear();
    for (int c = 0; c < 3; ++c)
      append(row, type, file.points[i][c]);
    for (int c = 0; c < 3 && !file.normals.empty(); ++c)
      append(row, type, file.normals[i][c]);
    for (std::size_t c = 0; c < columns.size(); ++c)
      append(row, columns[c].type, record.values[c]);
    row += end_of_row;
    out.write(row.data(), std::streamsize(row.size()));
    ++i;
  });
}

inline void append_column(std::string& row, Scalar type, double number)
{
  if (!row.empty())
    row += ' ';
  append_text(row, type, number);
}

inline void write_as_xyz(std::ostream& out, const Point_file& file)
{
  write_rows(out, file, append_column, "\n");
}

inline void write_as_off(std::ostream& out, const Point_file& file)
{
  out << (file.normals.empty() ? "OFF\n" : "NOFF\n") << file.points.size() << " 0 0\n";
  write_rows(out, file, append_column, "\n");
}

inline void write_as_ply(std::ostream& out, const Point_file& file)
{
  const std::string type = name_of(file.coordinate_type());
  out << "ply\nformat binary_little_endian 1.0\nelement vertex " << file.points.size() << '\n';
  for (const char* name : {"x", "y", "z"})
    out << "property " << type << ' ' << name << '\n';
  for (const char* name : {"nx", "ny", "nz"})
    if (!file.normals.empty())
      out << "property " << type << ' ' << name << '\n';
  for (const Property& column : file.columns())
    out << "property " << name_of(column.type) << ' ' << column.name << '\n';
  out << "end_header\n";
  const std::uint16_t one = 1;
  const bool swapped = reinterpret_cast<const char&>(one) != 1;
  const auto append = [swapped](std::string& row, Scalar number_type, double number) {
    append_bytes(row, number_type, number, swapped);
  };
  write_rows(out, file, append, "");
}

#endif // BALANCED_FLOW_SMOOTH_CONVERT_H
