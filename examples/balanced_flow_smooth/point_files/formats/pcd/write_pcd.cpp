// SPDX-License-Identifier: GPL-3.0-or-later
#include "write_pcd.h"

#include "../../Raw_file.h"
#include "../../write_rows.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace point_files::pcd {

namespace {

/// A field that is made of columns, one after the other
struct New_field {
  std::string name;
  char type;
  std::size_t size;
  std::vector<std::size_t> columns;
};

char letter_of(Scalar type) { return !is_integer(type) ? 'F' : is_unsigned(type) ? 'U' : 'I'; }

std::size_t find(const std::vector<Property>& columns, const std::string& name)
{
  const auto has_name = [&](const Property& column) { return column.name == name; };
  return std::size_t(std::find_if(columns.begin(), columns.end(), has_name) - columns.begin());
}

/// The columns of colors that fit a byte each: blue, green, red, and alpha if it is there; nothing if
/// there are none.
std::vector<std::size_t> find_colors(const Point_file& file, const std::vector<Property>& columns)
{
  std::vector<std::size_t> colors;
  if (find(columns, "rgb") != columns.size() || find(columns, "rgba") != columns.size())
    return colors;
  for (const char* name : {"blue", "green", "red", "alpha"}) {
    const std::size_t column = find(columns, name);
    // text has no types
    if (column != columns.size() &&
        (columns[column].type == Scalar::UINT8 || columns[column].type == Scalar::INT32))
      colors.push_back(column);
    else if (colors.size() < 3)
      return {};
  }
  bool all_fit = true;
  for_each_record_to_write(file, [&](std::size_t, const Record& record) {
    for (const std::size_t c : colors) {
      const double value = to_double(record.values[c]);
      all_fit = all_fit && value >= 0. && value < 256.;
    }
  });
  return all_fit ? colors : std::vector<std::size_t>();
}

std::vector<New_field> fields_of(const std::vector<Property>& columns,
                                 const std::vector<std::size_t>& colors)
{
  std::vector<New_field> fields;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    const Scalar type = columns[c].type;
    const std::string name = column_name(columns[c]);
    if (!colors.empty() && c == colors[2]) // a float by tradition, but for alpha
      fields.push_back(
          {colors.size() == 4 ? "rgba" : "rgb", colors.size() == 4 ? 'U' : 'F', 4, colors});
    else if (std::find(colors.begin(), colors.end(), c) == colors.end())
      fields.push_back({name == "_" ? "column_" + std::to_string(c + 1) : name,
                        letter_of(type),
                        size_of(type),
                        {c}});
  }
  return fields;
}

std::string header_of(const std::vector<New_field>& fields, std::size_t count)
{
  std::string names, sizes, types, counts;
  for (const New_field& field : fields) {
    names += " " + field.name;
    sizes += " " + std::to_string(field.size);
    types += std::string(" ") + field.type;
    counts += " 1";
  }
  const std::string number = std::to_string(count);
  return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS" + names + "\nSIZE" +
         sizes + "\nTYPE" + types + "\nCOUNT" + counts + "\nWIDTH " + number +
         "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + number + "\nDATA binary\n";
}

} // namespace

void write_pcd(const Target& target, const Point_file& file)
{
  const std::vector<Property> columns = file.columns();
  const std::vector<std::size_t> colors = find_colors(file, columns);
  const std::vector<New_field> others = fields_of(columns, colors);
  const Scalar type = file.coordinate_type();
  std::vector<New_field> fields;
  for (const char* name : {"x", "y", "z"})
    fields.push_back({name, 'F', size_of(type), {}});
  for (const char* name : {"normal_x", "normal_y", "normal_z"})
    if (!file.normals.empty())
      fields.push_back({name, 'F', size_of(type), {}});
  fields.insert(fields.end(), others.begin(), others.end());
  target.out << header_of(fields, file.number_of_points_to_write());

  const bool swapped = !is_little_endian();
  std::string row;
  for_each_record_to_write(file, [&](std::size_t i, const Record& record) {
    row.clear();
    for (int c = 0; c < 3; ++c)
      append_bytes(row, type, file.points[i][c], swapped);
    for (int c = 0; c < 3 && !file.normals.empty(); ++c)
      append_bytes(row, type, file.normals[i][c], swapped);
    for (const New_field& field : others) {
      const bool is_color = field.columns == colors;
      for (const std::size_t c : field.columns)
        append_bytes(row, is_color ? Scalar::UINT8 : columns[c].type, record.values[c], swapped);
      if (is_color && colors.size() == 3)
        row += '\0';
    }
    target.out.write(row.data(), std::streamsize(row.size()));
  });
}

} // namespace point_files::pcd
