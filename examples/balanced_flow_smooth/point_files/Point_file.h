// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_FILES_POINT_FILE_H
#define POINT_FILES_POINT_FILE_H

#include "Format.h"
#include "Layout.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace point_files {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point_3;
typedef Kernel::Vector_3 Vector_3;

/// A point as it is in the file
struct Record {
  double coordinates[3], normal[3];
  std::vector<Number> values; // of the columns
};

/// Where a file goes
struct Target {
  std::ostream& out;
  std::filesystem::path path; // of the stream; empty if that is no file
  const Format& format;
};

/// A file of points: what it holds stays as it is, and beside it are its points, to be moved.
class Point_file {
public:
  const Format* format = nullptr; // of the file; set by `read_point_file()` if its reader does not
  std::vector<Point_3> points;
  std::vector<Vector_3> normals; // empty if there are none
  /// vectors from the points to the scanner, null where it is not known; empty if it is for none
  std::vector<Vector_3> sides;
  /// the number of the scan of each point, from 0 on; empty if all are of one
  std::vector<std::uint32_t> scans;
  std::vector<std::string> warnings;

  /// what was taken for coordinates and normals: the numbers of columns or properties, from 1 on, and
  /// what told it, for people; empty if the format leaves no choice
  std::vector<std::pair<std::string, std::size_t>> roles;
  std::string roles_source;

  std::vector<std::size_t> invalid; // which points are none, ascending; they are not smoothed
  bool drops_invalid = false;       // whether these are not written
  bool defines_invalid = false;     // whether the format has a meaning for them
  bool zeros_are_invalid = false;   // whether it means them by (0, 0, 0)

  virtual ~Point_file() = default;

  /// Writes the file with the points, and with the normals if there are any, that are now here;
  /// nothing else changes. A value that is the same as before is kept to the letter.
  virtual void write(const Target& target) const = 0;

  typedef std::function<void(const Record&)> Visitor;
  /// Goes through the points as they are in the file.
  /// \param with_values whether the values of the columns are wanted
  virtual void for_each_record(bool with_values, const Visitor& visit) const = 0;

  /// what other formats can take beside points and normals
  virtual std::vector<Property> columns() const = 0;
  /// and what they can not
  virtual std::vector<std::string> losses() const = 0;
  virtual Scalar coordinate_type() const = 0;

  std::size_t number_of_points_to_write() const
  {
    return points.size() - (drops_invalid ? invalid.size() : 0);
  }
  bool is_dropped(std::size_t i) const
  {
    return drops_invalid && std::binary_search(invalid.begin(), invalid.end(), i);
  }

  /// Makes room for normals if there are none.
  void add_normals() { normals.resize(points.size(), CGAL::NULL_VECTOR); }

protected:
  /// Reads the points, and the normals if there are any; throws `std::runtime_error` if there are no
  /// points.
  void load(std::size_t count, bool with_normals);
};

} // namespace point_files

#endif // POINT_FILES_POINT_FILE_H
