// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_FILES_LAS_RECORD_FORMAT_H
#define POINT_FILES_LAS_RECORD_FORMAT_H

#include <pdal/PointLayout.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <string>

namespace point_files::las {

typedef pdal::Dimension::Id Id;

/// What the header of a file tells of the records of the points
struct Record_format {
  unsigned int id = 7, length = 0;

  Record_format() = default;
  explicit Record_format(const std::filesystem::path& path)
  {
    std::ifstream in(path, std::ios::binary);
    in.seekg(104);
    unsigned int bytes[3] = {0, 0, 0};
    for (unsigned int& byte : bytes)
      byte = static_cast<unsigned char>(in.get());
    id = bytes[0] & 0x3f; // the other bits tell of compression
    length = bytes[1] + 256 * bytes[2];
  }

  /// whether a dimension has its place in each record, so that it is no extra one
  bool has(const std::string& dimension) const
  {
    const auto is_in = [&](std::initializer_list<const char*> names) {
      return std::find(names.begin(), names.end(), dimension) != names.end();
    };
    if (is_in({"Red", "Green", "Blue"}))
      return id == 2 || id == 3 || id == 5 || id == 7 || id == 8 || id == 10;
    if (dimension == "Infrared")
      return id == 8 || id == 10;
    if (dimension == "GpsTime")
      return id != 0 && id != 2;
    return is_in({"X", "Y", "Z", "Intensity", "ReturnNumber", "NumberOfReturns",
                  "ScanDirectionFlag", "EdgeOfFlightLine", "Classification", "ScanAngleRank",
                  "UserData", "PointSourceId", "ScanChannel", "ClassFlags", "Synthetic", "KeyPoint",
                  "Withheld", "Overlap"});
  }

  /// the others, as PDAL's writer wants to be told; it adds too much if it may choose
  std::string extra_dimensions(const pdal::PointLayout& layout) const
  {
    std::string extra;
    for (const Id dimension : layout.dims()) {
      const std::string name = layout.dimName(dimension);
      if (!has(name))
        extra += (extra.empty() ? "" : ",") + name + "=" +
                 pdal::Dimension::interpretationName(layout.dimType(dimension));
    }
    return extra;
  }
};

} // namespace point_files::las

#endif // POINT_FILES_LAS_RECORD_FORMAT_H
