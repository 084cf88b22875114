// SPDX-License-Identifier: GPL-3.0-or-later
// LAS, and with LASzip LAZ
#include "Las_file.h"
#include "Las_stream.h"
#include "all_formats.h"
#include "las/Laz_records.h"
#include "las/New_las.h"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>

namespace point_files {

namespace {

constexpr std::size_t place_of_format = 104; // in the header; the first bit tells of compression

Format las_or_laz(const char* name)
{
  Format format;
  format.name = name;
  format.family = "las";
  format.magic = "LASF";
  format.adds_normals = false;
  format.read = [](Bytes bytes, const Read_options&) -> std::unique_ptr<Point_file> {
    return std::make_unique<Las_file>(las::Input(std::string(bytes.view())));
  };
  format.read_path = [](const std::filesystem::path& path,
                        const Read_options&) -> std::unique_ptr<Point_file> {
    return std::make_unique<Las_file>(las::Input(path));
  };
  format.stream = open_las_stream;
  format.write = [](const Target& target, const Point_file& file) {
    las::New_las(file).write(target);
  };
  return format;
}

bool is_compressed(const Bytes& bytes)
{
  return bytes.size() > place_of_format &&
         (static_cast<unsigned char>(bytes[place_of_format]) & 0x80) != 0;
}

} // namespace

Format las_format()
{
  Format format = las_or_laz("las");
  format.recognizes = [](const Bytes& bytes) { return !is_compressed(bytes); };
  return format;
}

Format laz_format()
{
  Format format = las_or_laz("laz");
  format.recognizes = is_compressed;
  format.library = "LASzip";
  format.package = "liblaszip-dev in Debian 13 and Ubuntu 24.04";
  if (!las::has_laszip())
    format.read = nullptr, format.read_path = nullptr, format.stream = nullptr,
    format.write = nullptr;
  return format;
}

} // namespace point_files
