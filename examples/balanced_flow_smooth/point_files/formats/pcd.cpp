// SPDX-License-Identifier: GPL-3.0-or-later
// PCD, the format of the Point Cloud Library: ascii, binary and binary_compressed
#include "../Raw_stream.h"
#include "all_formats.h"
#include "pcd/Compressed_file.h"
#include "pcd/Header.h"
#include "pcd/write_pcd.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace point_files {

namespace {

Scalar scalar_of(const pcd::Value_field& field)
{
  if (field.type == 'F')
    return field.size == 8 ? Scalar::DOUBLE : Scalar::FLOAT;
  const bool has_sign = field.type == 'I';
  switch (field.size) {
  case 1:
    return has_sign ? Scalar::INT8 : Scalar::UINT8;
  case 2:
    return has_sign ? Scalar::INT16 : Scalar::UINT16;
  case 4:
    return has_sign ? Scalar::INT32 : Scalar::UINT32;
  default:
    return has_sign ? Scalar::INT64 : Scalar::UINT64;
  }
}

/// What stands in a record, and the number of the field that each property belongs to
struct Record_plan {
  std::vector<Property> properties;
  std::vector<std::size_t> fields;

  explicit Record_plan(const pcd::Header& header)
  {
    const auto is_color = [](const pcd::Value_field& f) {
      return f.name == "red" || f.name == "green" || f.name == "blue" || f.name == "alpha";
    };
    const bool splits_colors = header.data != pcd::Data::ASCII &&
                               std::none_of(header.fields.begin(), header.fields.end(), is_color);
    for (std::size_t f = 0; f < header.fields.size(); ++f) {
      const pcd::Value_field& field = header.fields[f];
      const bool is_packed = (field.name == "rgb" || field.name == "rgba") && field.size == 4;
      if (field.is_padding())
        add_padding(header.data == pcd::Data::ASCII ? field.count : field.width());
      else if (is_packed && field.count == 1 && splits_colors)
        add_color(field.name == "rgba");
      else
        add_values(field);
      fields.resize(properties.size(), f);
    }
  }

private:
  void add_padding(std::size_t count)
  {
    for (std::size_t i = 0; i < count; ++i)
      properties.emplace_back("_", Scalar::UINT8).is_padding = true;
  }

  /// The bytes of a color that is packed into one number: as a float it may be NaN, which does not keep
  /// all of its bits when it is converted.
  void add_color(bool has_alpha)
  {
    for (const char* name : {"blue", "green", "red", "alpha"})
      properties.emplace_back(name, Scalar::UINT8);
    properties.back().is_padding = !has_alpha;
  }

  void add_values(const pcd::Value_field& field)
  {
    for (std::size_t i = 0; i < field.count; ++i)
      properties.emplace_back(field.name + (field.count == 1 ? "" : "_" + std::to_string(i + 1)),
                              scalar_of(field));
  }
};

/// Throws unless text has as many points as the header says.
void check_lines(const pcd::Header& header)
{
  Line_reader lines(header.end);
  Field line;
  for (std::size_t i = 0; i < header.count; ++i)
    if (!lines.next(line))
      throw std::runtime_error("the file ends after " + std::to_string(i) + " of " +
                               std::to_string(header.count) + " points");
  if (lines.next(line))
    lines.fail("there are more points than the " + std::to_string(header.count) + " of the header");
}

void check_size(const pcd::Header& header, std::size_t file_size)
{
  const std::size_t left = (file_size - header.end.at) / header.record_size();
  if (header.count > left)
    throw std::runtime_error("the file ends after " + std::to_string(left) + " of " +
                             std::to_string(header.count) + " points of " +
                             std::to_string(header.record_size()) + " bytes");
}

/// All but the bytes
Anatomy dissect(const pcd::Header& header, const Record_plan& plan)
{
  Anatomy file;
  if (header.data != pcd::Data::ASCII)
    file.encoding = is_little_endian() ? Encoding::BINARY : Encoding::SWAPPED_BINARY;
  file.layout = Layout(plan.properties);
  file.layout_source = "the names of the fields";
  Block block = {header.end, header.count, header.count_places};
  const Scan_frame::Triple& position = header.viewpoint;
  const bool is_moved = position != Scan_frame::Triple{0., 0., 0.};
  const auto is_finite = [](double number) { return std::isfinite(number); };
  if ((is_moved || header.is_image()) && std::all_of(position.begin(), position.end(), is_finite))
    block.frame = std::make_shared<Scan_frame>(position);
  file.blocks.push_back(block);
  file.normals_header = header.announce_normals(plan.fields[file.layout.last_coordinate()],
                                                file.layout.normal_type());
  if (header.rows != 1) {
    file.rows_field = header.rows_place;
    file.losses.push_back("the grid of the points");
  }
  if (is_moved)
    file.losses.push_back("the place of the scanner");
  file.defines_invalid = header.rows > 1;
  return file;
}

/// The points of a file that is not compressed
Anatomy parse(const Bytes& bytes, const pcd::Header& header)
{
  if (header.data == pcd::Data::ASCII)
    check_lines(header);
  else
    check_size(header, bytes.size());
  Anatomy file = dissect(header, Record_plan(header));
  file.bytes = bytes;
  const std::size_t size_of_rest = // old files have bytes behind compressed points
      header.data == pcd::Data::BINARY
          ? bytes.size() - header.end.at - header.count * header.record_size()
          : 0;
  if (size_of_rest != 0)
    file.warnings.push_back(std::to_string(size_of_rest) +
                            " bytes behind the points are kept as they are");
  return file;
}

std::unique_ptr<Point_file> read_pcd(Bytes bytes, const Read_options&)
{
  pcd::Header header(bytes);
  std::unique_ptr<Raw_file> file;
  if (header.data == pcd::Data::COMPRESSED) {
    std::string records = pcd::decompress(bytes, header);
    Anatomy anatomy = dissect(header, Record_plan(header));
    anatomy.bytes = std::move(records);
    file = std::make_unique<pcd::Compressed_file>(std::move(bytes), std::move(anatomy),
                                                  header.leaves_out_padding);
  }
  else
    file = std::make_unique<Raw_file>(parse(bytes, header));
  const Record_plan plan(header);
  for (auto& [role, number] : file->roles) // of fields
    number = plan.fields[number - 1] + 1;
  return file;
}

std::unique_ptr<Streamed_file> stream_pcd(const std::filesystem::path& path, const Read_options&)
{
  const Bytes bytes = Bytes::of_file(path);
  const pcd::Header header(bytes);
  if (header.data == pcd::Data::COMPRESSED)
    return nullptr;
  return std::make_unique<Raw_stream>(parse(bytes, header));
}

bool begins_with_header(const Bytes& bytes)
{
  if (bytes.compare(size_of_mark(bytes), 6, "# .PCD") == 0)
    return true;
  return first_word(bytes) == "VERSION";
}

} // namespace

Format pcd_format()
{
  Format format;
  format.name = format.family = "pcd";
  format.recognizes = begins_with_header;
  format.read = read_pcd;
  format.stream = stream_pcd;
  format.write = pcd::write_pcd;
  return format;
}

} // namespace point_files
