// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_EXAMPLES_POINT_SET_IO_H
#define BALANCED_FLOW_EXAMPLES_POINT_SET_IO_H

#include "Ply_header.h"
#include "Temporary_file.h"
#include "Text_table.h"

#include <CGAL/Point_set_3/IO.h>

#include <algorithm>
#include <atomic>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>

/// A point set with what its file says beside: enough to write the file again with nothing changed
/// but the points.
struct Point_set_file {
  Point_set points;
  std::string format;          // the extension in lower case
  std::string comments;        // PLY
  bool binary = true;          // PLY
  int digits = 17;             // PLY: as many as its numbers need, where they are text
  bool count_line = false;     // XYZ: the first line is the number of points
  std::string keyword = "OFF"; // OFF: "COFF", "NOFF", ...
  std::string counts, rest;    // OFF: faces and edges, and the lines of the faces
};

namespace point_set_io {

inline std::string format_of(const std::filesystem::path& path)
{
  std::string format = path.extension().string();
  std::transform(format.begin(), format.end(), format.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  if (format == ".pwn" || format == ".txt" || format == ".pts")
    return ".xyz";
  if (format != ".ply" && format != ".xyz" && format != ".off" && format != ".las" &&
      format != ".laz")
    throw std::runtime_error("the format \"" + format +
                             "\" is not known (ply, xyz, pwn, txt, pts, off, las)");
  return format;
}

inline void read_xyz(std::istream& in, Point_set_file& file)
{
  Line_reader reader(in);
  Text_table table;
  std::string line;
  double announced = 0.;
  while (reader.next(line)) {
    std::vector<double> alone;
    if (table.rows() == 0 && !file.count_line && (reader.parse(line, alone), alone.size() == 1)) {
      file.count_line = true;
      announced = alone[0];
    }
    else
      table.add(line, reader);
  }
  if (file.count_line && announced != double(table.rows()))
    throw std::runtime_error("the first line announces " + to_text(announced) +
                             " points, but there are " + std::to_string(table.rows()));
  table.move_to(file.points, table.has_normals());
}

inline void read_off(std::istream& in, Point_set_file& file)
{
  Line_reader reader(in);
  std::string line;
  if (!reader.next(line))
    throw std::runtime_error("the file is empty");
  std::istringstream header(line);
  header >> file.keyword;
  if (file.keyword.size() < 3 || file.keyword.substr(file.keyword.size() - 3) != "OFF")
    reader.fail("this is not an OFF file");
  if (line.find("BINARY") != std::string::npos)
    reader.fail("binary OFF is not supported");
  std::size_t vertices = 0;
  if (!(header >> vertices)) { // the counts stand on their own line
    if (!reader.next(line))
      reader.fail("the number of points is missing");
    header = std::istringstream(line);
    if (!(header >> vertices))
      reader.fail("the number of points is missing");
  }
  std::getline(header, file.counts);

  Text_table table;
  while (table.rows() < vertices && reader.next(line))
    table.add(line, reader);
  if (table.rows() != vertices)
    throw std::runtime_error("the file ends after " + std::to_string(table.rows()) + " of " +
                             std::to_string(vertices) + " points");
  const bool with_normals = file.keyword.find('N') != std::string::npos;
  if (with_normals && table.width < 6)
    reader.fail("the normals are missing");
  table.move_to(file.points, with_normals);
  std::ostringstream rest;
  rest << in.rdbuf();
  file.rest = rest.str();

  std::size_t faces = 0, found = 0;
  std::istringstream(file.counts) >> faces;
  std::istringstream lines(file.rest);
  for (Line_reader face_reader(lines); found < faces && face_reader.next(line);)
    ++found;
  if (found < faces)
    throw std::runtime_error("the file ends after " + std::to_string(found) + " of " +
                             std::to_string(faces) + " faces");
}

inline void read_ply(std::istream& in, Point_set_file& file)
{
  const Ply_header header = read_ply_header(in);
  file.binary = header.binary;
  file.digits = header.digits;
  if (header.normals)
    file.points.add_normal_map(); // before the others, to come out behind the coordinates
  in.seekg(0);
  if (!CGAL::IO::read_PLY(in, file.points, file.comments))
    throw std::runtime_error("this is not a complete PLY file");
}

inline void write_off(std::ostream& out, Point_set_file& file)
{
  const Column_writer columns(file.points);
  std::string keyword = file.keyword;
  if (file.points.has_normal_map() && keyword.find('N') == std::string::npos)
    keyword.insert(keyword.find("OFF"), "N");
  if (file.format != ".off" && !columns.columns().empty())
    std::cerr << "warning: OFF has no names for properties, they become columns" << std::endl;
  out << keyword << '\n'
      << file.points.size() << (file.counts.empty() ? " 0 0" : file.counts) << '\n';
  columns.write(out, file.points);
  out << file.rest;
}

/// LAS has a fixed set of properties. CGAL leaves out, without a word, what is not one of them or
/// has another type.
inline void warn_of_las_losses(const Point_set& points)
{
  typedef unsigned char Byte;
  typedef unsigned short Short;
  static const std::map<std::string, std::type_index> kept = {
      {"intensity", typeid(Short)},
      {"return_number", typeid(Byte)},
      {"number_of_returns", typeid(Byte)},
      {"scan_direction_flag", typeid(Byte)},
      {"edge_of_flight_line", typeid(Byte)},
      {"classification", typeid(Byte)},
      {"synthetic_flag", typeid(Byte)},
      {"keypoint_flag", typeid(Byte)},
      {"withheld_flag", typeid(Byte)},
      {"scan_angle", typeid(float)},
      {"user_data", typeid(Byte)},
      {"point_source_ID", typeid(Short)},
      {"deleted_flag", typeid(unsigned int)},
      {"gps_time", typeid(double)},
      {"R", typeid(Short)},
      {"G", typeid(Short)},
      {"B", typeid(Short)},
      {"I", typeid(Short)},
      {"red", typeid(Byte)},
      {"green", typeid(Byte)},
      {"blue", typeid(Byte)}};
  for (const auto& property : points.properties_and_types()) {
    const auto found = kept.find(property.first);
    if (found == kept.end() || found->second != property.second)
      std::cerr << "warning: LAS can not keep \"" << property.first << "\"" << std::endl;
  }
}

inline void write(std::ostream& out, const std::string& format, Point_set_file& file)
{
  bool written = true;
  if (format == ".off")
    write_off(out, file);
  else if (format == ".xyz") {
    if (file.count_line)
      out << file.points.size() << '\n';
    Column_writer(file.points).write(out, file.points);
  }
  else if (format == ".ply") {
    CGAL::IO::set_mode(out, file.binary ? CGAL::IO::BINARY : CGAL::IO::ASCII);
    out.precision(file.digits);
    written = CGAL::IO::write_PLY(out, file.points, file.comments);
  }
#ifdef CGAL_LINKED_WITH_LASLIB
  else {
    warn_of_las_losses(file.points);
    written = CGAL::IO::write_LAS(out, file.points);
  }
#endif
  if (!written || !out.flush())
    throw std::runtime_error("writing failed");
}

inline void check_format([[maybe_unused]] const std::string& format)
{
#ifndef CGAL_LINKED_WITH_LASLIB
  if (format == ".las" || format == ".laz")
    throw std::runtime_error("this program was built without LAS support (LASlib)");
#endif
}

} // namespace point_set_io

/// Reads a point set; throws `std::runtime_error` with the reason if it can not.
inline Point_set_file read_point_set_file(const std::filesystem::path& path)
{
  try {
    Point_set_file file;
    file.format = point_set_io::format_of(path);
    point_set_io::check_format(file.format);
    if (std::filesystem::is_directory(path))
      throw std::runtime_error("this is a directory");
    std::ifstream in(path, std::ios::binary);
    if (!in)
      throw std::runtime_error("the file can not be opened");
    if (file.format == ".ply")
      point_set_io::read_ply(in, file);
    else if (file.format == ".off")
      point_set_io::read_off(in, file);
    else if (file.format == ".xyz")
      point_set_io::read_xyz(in, file);
#ifdef CGAL_LINKED_WITH_LASLIB
    else if (!CGAL::IO::read_LAS(in, file.points))
      throw std::runtime_error("this is not a complete LAS file");
#endif
    if (in.bad())
      throw std::runtime_error("reading failed");
    if (file.points.empty())
      throw std::runtime_error("there are no points in it");
    return file;
  }
  catch (const std::exception& e) {
    throw std::runtime_error("cannot read " + path.string() + ": " + e.what());
  }
}

/// Throws `std::runtime_error` if the output could not be written, before any work is done.
inline void check_output(const std::filesystem::path& path)
{
  try {
    const std::string format = point_set_io::format_of(path);
    point_set_io::check_format(format);
    if (format == ".laz")
      throw std::runtime_error("CGAL writes LAS only without compression, as .las");
    if (std::filesystem::is_directory(path))
      throw std::runtime_error("this is a directory");
    if (std::filesystem::exists(path) && !std::filesystem::is_regular_file(path))
      throw std::runtime_error("this is not a regular file");
    if (path.has_parent_path() && !std::filesystem::is_directory(path.parent_path()))
      throw std::runtime_error("there is no directory " + path.parent_path().string());
    const Temporary_file trial(path);
  }
  catch (const std::exception& e) {
    throw std::runtime_error("cannot write " + path.string() + ": " + e.what());
  }
}

/// Writes a point set, first beside the file and then in its place: a run that fails or is killed
/// never leaves half a file. If `cancelled` by then, nothing is written.
/// \return whether the file is written
inline bool write_point_set_file(const std::filesystem::path& path, Point_set_file& file,
                                 const std::atomic<bool>& cancelled)
{
  try {
    Temporary_file out(path);
    point_set_io::write(out.stream(), point_set_io::format_of(path), file);
    if (cancelled)
      return false;
    out.take_place();
    return true;
  }
  catch (const std::exception& e) {
    throw std::runtime_error("cannot write " + path.string() + ": " + e.what());
  }
}

#endif // BALANCED_FLOW_EXAMPLES_POINT_SET_IO_H
