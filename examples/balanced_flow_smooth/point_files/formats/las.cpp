// SPDX-License-Identifier: GPL-3.0-or-later
// LAS and LAZ, if PDAL is there
#include "all_formats.h"

#ifdef POINT_SET_FLOW_WITH_PDAL
#include "Las_file.h"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>
#endif

namespace point_files {

namespace {

#ifdef POINT_SET_FLOW_WITH_PDAL
/// Writes the points of another format; its columns become dimensions by their names.
void write_las(const Target& target, const Point_file& file)
{
  pdal::PointTable table;
  for (const las::Id id : las::coordinates)
    table.layout()->registerDim(id, pdal::Dimension::Type::Double);
  for (const las::Id id : las::normals)
    if (!file.normals.empty())
      table.layout()->registerDim(id, pdal::Dimension::Type::Double);
  std::vector<las::Id> ids;
  for (const Property& column : file.columns())
    ids.push_back(table.layout()->registerOrAssignDim(column.name, las::type_of(column.type)));
  table.finalize();

  const auto view = std::make_shared<pdal::PointView>(table);
  pdal::PointId i = 0;
  file.for_each_record(true, [&](const Record& record) {
    las::set(*view, i, las::coordinates, file.points[i]);
    if (!file.normals.empty())
      las::set(*view, i, las::normals, file.normals[i]);
    for (std::size_t c = 0; c < ids.size(); ++c)
      view->setField(ids[c], i, record.values[c]);
    ++i;
  });
  pdal::Options options;
  for (const char* axis : {"x", "y", "z"}) {
    options.add(std::string("scale_") + axis, "auto"); // all 31 bits
    options.add(std::string("offset_") + axis, "auto");
  }
  const las::Record_format format;
  options.add("minor_version", 4); // the first that describes extra dimensions
  options.add("dataformat_id", format.id);
  las::write_view(target, table, view, options, format);
}
#endif

Format las_or_laz(const char* name)
{
  Format format;
  format.name = name;
  format.family = "las";
  format.library = "PDAL";
#ifdef POINT_SET_FLOW_WITH_PDAL
  format.read = [](std::string bytes, const Read_options& options) -> std::unique_ptr<Point_file> {
    return Las_file::of_bytes(bytes, options.with_normals);
  };
  format.read_path = [](const std::filesystem::path& path,
                        const Read_options& options) -> std::unique_ptr<Point_file> {
    return std::make_unique<Las_file>(path, options.with_normals);
  };
  format.write = write_las;
#endif
  return format;
}

} // namespace

Format las_format()
{
  Format format = las_or_laz("las");
  format.magic = "LASF"; // also of LAZ, which is read the same way
  return format;
}

Format laz_format() { return las_or_laz("laz"); }

} // namespace point_files
