// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_FILES_LAS_FILE_H
#define POINT_FILES_LAS_FILE_H

#include "../Point_file.h"
#include "Las_record_format.h"
#include "Spool_file.h"

#include <pdal/Options.hpp>
#include <pdal/PointTable.hpp>
#include <pdal/PointView.hpp>
#include <pdal/StageFactory.hpp>
#include <pdal/io/BufferReader.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

namespace point_files {

// LAS and LAZ through PDAL, which keeps what belongs to a point as dimensions of a view, and what is
// in the header in the metadata of a table, from which its writer can take it.

namespace las {

constexpr std::array<Id, 3> coordinates = {Id::X, Id::Y, Id::Z};
constexpr std::array<Id, 3> normals = {Id::NormalX, Id::NormalY, Id::NormalZ};

inline Point_3 point(const pdal::PointView& view, pdal::PointId i, const std::array<Id, 3>& ids)
{
  return Point_3(view.getFieldAs<double>(ids[0], i), view.getFieldAs<double>(ids[1], i),
                 view.getFieldAs<double>(ids[2], i));
}

template <typename Triple>
void set(pdal::PointView& view, pdal::PointId i, const std::array<Id, 3>& ids, const Triple& value)
{
  for (std::size_t c = 0; c < 3; ++c)
    view.setField(ids[c], i, value[int(c)]);
}

/// Writes the points of a view to a file, and that to the stream if they are not the same.
inline void write_view(const Target& target, pdal::PointTable& table, pdal::PointViewPtr view,
                       pdal::Options options, const Record_format& format)
{
  const Spool_file spool;
  const bool is_spooled = Spool_file::is_needed_for(target.path);
  const std::filesystem::path path = is_spooled ? spool.path() : target.path;
  options.add("filename", path.string());
  const std::string extra = format.extra_dimensions(*table.layout());
  if (!extra.empty())
    options.add("extra_dims", extra);
  options.add("compression", target.format.name == "laz" ? "true" : "none");

  pdal::BufferReader buffer;
  buffer.addView(view);
  pdal::StageFactory factory;
  pdal::Stage& writer = *factory.createStage("writers.las");
  writer.setInput(buffer);
  writer.setOptions(options);
  writer.prepare(table);
  writer.execute(table);
  if (format.length != 0 && Record_format(path).length != format.length)
    throw std::runtime_error(
        "there are bytes in the records of the points that the header does not "
        "describe: PDAL would lose them");
  if (is_spooled)
    target.out << std::ifstream(path, std::ios::binary).rdbuf();
}

inline Scalar scalar_of(pdal::Dimension::Type type)
{
  typedef pdal::Dimension::Type Type;
  switch (type) {
  case Type::Signed8:
    return Scalar::INT8;
  case Type::Unsigned8:
    return Scalar::UINT8;
  case Type::Signed16:
    return Scalar::INT16;
  case Type::Unsigned16:
    return Scalar::UINT16;
  case Type::Signed32:
    return Scalar::INT32;
  case Type::Unsigned32:
    return Scalar::UINT32;
  case Type::Float:
    return Scalar::FLOAT;
  default: // also integers of 64 bits
    return Scalar::DOUBLE;
  }
}

inline pdal::Dimension::Type type_of(Scalar scalar)
{
  typedef pdal::Dimension::Type Type;
  constexpr Type types[] = {Type::Signed8,  Type::Unsigned8,  Type::Signed16, Type::Unsigned16,
                            Type::Signed32, Type::Unsigned32, Type::Float,    Type::Double};
  return types[std::size_t(scalar)];
}

} // namespace las

/// A LAS or LAZ file
class Las_file : public Point_file {
  mutable pdal::PointTable m_table; // the writer looks up there what was in the header
  pdal::StageFactory m_factory;
  pdal::PointViewPtr m_view;
  bool m_has_normals = true;
  las::Record_format m_format;

public:
  /// \param with_normals whether normals are wanted even if there are none in the file
  Las_file(const std::filesystem::path& path, bool with_normals) : m_format(path)
  {
    pdal::Options options;
    options.add("filename", path.string());
    options.add("use_eb_vlr", true); // dimensions of the file's own, also before LAS 1.4
    pdal::Stage& reader = *m_factory.createStage("readers.las");
    reader.setOptions(options);
    reader.prepare(m_table);
    for (const las::Id id : las::normals)
      m_has_normals = m_has_normals && m_table.layout()->hasDim(id);
    if (with_normals && !m_has_normals) // there is no adding later
      for (const las::Id id : las::normals) {
        m_table.layout()->registerDim(id, pdal::Dimension::Type::Double);
        m_format.length += unsigned(sizeof(double));
      }
    m_view = *reader.execute(m_table).begin();
    const auto announced = reader.getMetadata().findChild("count").value<std::size_t>();
    if (m_view->size() != announced) // PDAL takes what there is
      throw std::runtime_error("the file ends after " + std::to_string(m_view->size()) + " of " +
                               std::to_string(announced) + " points");
    load(m_view->size(), m_has_normals);
  }

  static std::unique_ptr<Las_file> of_bytes(const std::string& bytes, bool with_normals)
  {
    const Spool_file spool;
    std::ofstream(spool.path(), std::ios::binary) << bytes << std::flush;
    return std::make_unique<Las_file>(spool.path(), with_normals);
  }

  void write(const Target& target) const override
  {
    const pdal::PointViewPtr view = m_view->makeNew();
    view->append(*m_view);
    for (std::size_t i = 0; i < points.size(); ++i) {
      las::set(*view, i, las::coordinates, points[i]);
      if (!normals.empty())
        las::set(*view, i, las::normals, normals[i]);
    }
    pdal::Options options;
    options.add("forward", "all");
    las::write_view(target, m_table, view, options, m_format);
  }

  void for_each_record(bool with_values, const Visitor& visit) const override
  {
    const std::vector<las::Id> ids = with_values ? others() : std::vector<las::Id>();
    Record record = {{0., 0., 0.}, {0., 0., 0.}, std::vector<double>(ids.size())};
    for (pdal::PointId i = 0; i < m_view->size(); ++i) {
      for (std::size_t c = 0; c < 3; ++c) {
        record.coordinates[c] = m_view->getFieldAs<double>(las::coordinates[c], i);
        if (m_has_normals)
          record.normal[c] = m_view->getFieldAs<double>(las::normals[c], i);
      }
      for (std::size_t c = 0; c < ids.size(); ++c)
        record.values[c] = m_view->getFieldAs<double>(ids[c], i);
      visit(record);
    }
  }

  std::vector<Property> columns() const override
  {
    std::vector<Property> columns;
    for (const las::Id id : others())
      columns.emplace_back(m_table.layout()->dimName(id),
                           las::scalar_of(m_table.layout()->dimType(id)));
    return columns;
  }

  std::vector<std::string> losses() const override { return {"the header with its projection"}; }
  Scalar coordinate_type() const override { return Scalar::DOUBLE; }

private:
  std::vector<las::Id> others() const
  {
    std::vector<las::Id> others;
    for (const las::Id id : m_table.layout()->dims())
      if (std::find(las::coordinates.begin(), las::coordinates.end(), id) ==
              las::coordinates.end() &&
          std::find(las::normals.begin(), las::normals.end(), id) == las::normals.end())
        others.push_back(id);
    return others;
  }
};

} // namespace point_files

#endif // POINT_FILES_LAS_FILE_H
