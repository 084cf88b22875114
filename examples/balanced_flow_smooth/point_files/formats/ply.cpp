// SPDX-License-Identifier: GPL-3.0-or-later
// PLY, as text or binary of either byte order
#include "../Raw_stream.h"
#include "../Record_cursor.h"
#include "../write_rows.h"
#include "Ply_header.h"
#include "all_formats.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace point_files {

namespace {

constexpr Text_style style = {' ', true};

/// Skips the records of an element; throws if they are not all there.
/// \param by_lines of text: enough if no points come after them, and lines need not be understood
void skip_element(const Ply_element& element, Encoding encoding, bool by_lines, Place& place)
{
  const auto fail = [&](std::size_t found) {
    throw std::runtime_error("this is not a complete PLY file: it ends after " +
                             std::to_string(found) + " of " + std::to_string(element.count) +
                             " times " + element.name);
  };
  if (element.properties.empty())
    return;
  if (encoding == Encoding::TEXT) {
    Line_reader lines(place);
    Text_cursor records(place, element.properties, style);
    Field line;
    for (std::size_t i = 0; i < element.count; ++i)
      if (!(by_lines ? lines.next(line) : records.next() != nullptr))
        fail(i);
    place = by_lines ? lines.place() : records.place();
    return;
  }

  const std::size_t left = place.bytes->size() - place.at;
  const std::size_t size = element.fixed_size();
  if (element.has_lists()) {
    for (std::size_t i = 0; i < element.count; ++i)
      for (const Property& property : element.properties) {
        const auto end = Binary_cursor::find_end(*place.bytes, property, place.at,
                                                 encoding == Encoding::SWAPPED_BINARY);
        if (!end)
          fail(i);
        place.at = *end;
      }
  }
  else {
    if (element.count > left / size)
      fail(left / size);
    place.at += size * element.count;
  }
}

/// Takes an element for the points.
void take_points(const Ply_element& element, const std::string& end_of_line, const Place& place,
                 Anatomy& file)
{
  const std::vector<Property>& properties = element.properties;
  file.layout = Layout(properties);
  file.layout_source = "the names of the properties";
  file.blocks = {{place, element.count, {element.count_field}}};
  for (const Property& property : properties)
    if (property.count_type)
      file.losses.push_back("the lists " + property.name);

  const std::string type = name_of(file.layout.normal_type());
  const auto is_taken = [](const Property& p) { return role_of(p.name)[0] == 'n'; };
  const bool is_any_taken = std::any_of(properties.begin(), properties.end(), is_taken);
  std::string lines;
  for (const char axis : {'x', 'y', 'z'})
    lines += "property " + type + (is_any_taken ? " normal_" : " n") + axis + end_of_line;
  file.normals_header = {{element.property_ends[file.layout.last_coordinate()], lines}};
}

Anatomy parse(Bytes bytes, const Read_options&)
{
  Anatomy file;
  const Ply_header header(bytes);
  file.bytes = std::move(bytes);
  file.encoding = header.encoding;
  file.style = style;
  Place place = {&file.bytes, header.end, header.number_of_lines};
  bool has_points = false;
  for (const Ply_element& element : header.elements) {
    const bool is_point = element.has_points() && !has_points;
    if (is_point)
      take_points(element, header.end_of_line, place, file);
    else
      file.losses.push_back("the PLY element " + element.name);
    if (!is_point && element.count != 0)
      file.obstacle_to_dropping = "the element " + element.name + " may tell them by their number";
    skip_element(element, file.encoding, has_points, place);
    has_points = has_points || is_point;
  }
  if (!has_points)
    throw std::runtime_error("there are no points in it");
  return file;
}

void write_ply(const Target& target, const Point_file& file)
{
  std::ostream& out = target.out;
  const std::string type = name_of(file.coordinate_type());
  out << "ply\nformat binary_little_endian 1.0\nelement vertex " << file.number_of_points_to_write()
      << '\n';
  for (const char* name : {"x", "y", "z"})
    out << "property " << type << ' ' << name << '\n';
  for (const char* name : {"nx", "ny", "nz"})
    if (!file.normals.empty())
      out << "property " << type << ' ' << name << '\n';
  for (const Property& column : file.columns())
    out << "property " << name_of(column.type) << ' ' << column_name(column) << '\n';
  out << "end_header\n";
  const bool swapped = !is_little_endian();
  const auto append = [swapped](std::string& row, Scalar number_type, const Number& number) {
    append_bytes(row, number_type, number, swapped);
  };
  write_rows(out, file, append, "");
}

} // namespace

Format ply_format()
{
  Format format;
  format.name = format.family = "ply";
  format.recognizes = [](const Bytes& bytes) {
    const std::size_t begin = size_of_mark(bytes);
    return bytes.compare(begin, 3, "ply") == 0 && bytes.find_first_of("\r\n", begin) == begin + 3;
  };
  set_readers<parse>(format);
  format.write = write_ply;
  return format;
}

} // namespace point_files
