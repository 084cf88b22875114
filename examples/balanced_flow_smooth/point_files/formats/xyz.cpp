// SPDX-License-Identifier: GPL-3.0-or-later
// Text with a point in each line: one reader, and formats that differ in what they mean and write
#include "../Raw_stream.h"
#include "../write_rows.h"
#include "Text_parser.h"
#include "all_formats.h"

#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace point_files {

namespace {

typedef Text_parser::Names Names;

template <Names (*names)(std::size_t)>
Anatomy parse(Bytes bytes, const Read_options& options)
{
  Text_parser parser(std::move(bytes), options.columns);
  Anatomy anatomy = parser.parse(names);
  if (anatomy.layout_source.empty())
    anatomy.layout_source = "their order";
  if (parser.has_unnamed_normals() && !anatomy.layout.has_normals())
    anatomy.warnings.push_back("columns 4 to 6 look like normals, but nothing says that they are, "
                               "so they are kept: --columns x,y,z,nx,ny,nz would smooth them, too");
  return anatomy;
}

Names points_first(std::size_t width) { return default_names(width, false); }

Names normals_after_points(std::size_t width)
{
  if (width < 6)
    throw std::runtime_error("PWN has normals in columns 4 to 6, but there are " +
                             std::to_string(width) + " columns (--format xyz reads points alone)");
  return default_names(width, true);
}

template <Names (*names)(std::size_t)>
Format text_format(const char* name)
{
  Format format;
  format.name = format.family = name;
  format.has_columns = true;
  set_readers<parse<names>>(format);
  return format;
}

} // namespace

Format xyz_format()
{
  Format format = text_format<points_first>("xyz");
  format.extensions = {"txt", "asc"};
  format.write = [](const Target& target, const Point_file& file) {
    if (!file.normals.empty() || !file.columns().empty()) // three columns are clear
      target.out << "# " << names_of_rows(file) << '\n';
    write_text_rows(target.out, file);
  };
  return format;
}

Format csv_format()
{
  Format format = text_format<points_first>("csv");
  format.write = [](const Target& target, const Point_file& file) {
    target.out << names_of_rows(file, ',') << '\n';
    write_text_rows(target.out, file, ',');
  };
  return format;
}

Format pts_format()
{
  Format format = text_format<names_of_scan_columns>("pts");
  format.columns_warning = "PTS has no names for properties, they become columns";
  format.write = [](const Target& target, const Point_file& file) {
    if (!file.normals.empty()) // they would pass for colors
      target.out << "# " << names_of_rows(file) << '\n';
    target.out << file.number_of_points_to_write() << '\n';
    write_text_rows(target.out, file);
  };
  return format;
}

Format pwn_format()
{
  Format format = text_format<normals_after_points>("pwn");
  format.extensions = {"xyzn"};
  format.columns_warning = "PWN has no names for properties, they become columns";
  format.write = [](const Target& target, const Point_file& file) {
    if (file.normals.empty())
      throw std::runtime_error("PWN is for points with normals: --normals adds them");
    write_text_rows(target.out, file);
  };
  return format;
}

} // namespace point_files
