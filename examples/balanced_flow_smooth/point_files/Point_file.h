// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_SMOOTH_POINT_FILE_H
#define BALANCED_FLOW_SMOOTH_POINT_FILE_H

#include "Format.h"
#include "Layout.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point_3;
typedef Kernel::Vector_3 Vector_3;

/// A point as it is in the file
struct Record {
  double coordinates[3], normal[3];
  std::vector<double> values; // of the columns
};

/// Where a file goes
struct Target {
  std::ostream& out;
  std::filesystem::path path; // of the stream; empty if that is no file
  Format format;
};

/// A file of points: what it holds stays as it is, and beside it are its points, to be moved.
class Point_file {
public:
  std::vector<Point_3> points;
  std::vector<Vector_3> normals; // empty if there are none
  std::vector<std::string> warnings;

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

  void add_normals() { normals.resize(points.size(), CGAL::NULL_VECTOR); }

  /// the mean distance of the points from where they are in the file
  double mean_movement() const
  {
    double total = 0.;
    std::size_t i = 0;
    for_each_record(false, [&](const Record& r) {
      const Point_3& p = points[i++];
      total +=
          std::hypot(p.x() - r.coordinates[0], p.y() - r.coordinates[1], p.z() - r.coordinates[2]);
    });
    return points.empty() ? 0. : total / double(points.size());
  }

protected:
  void load(std::size_t count, bool with_normals)
  {
    points.reserve(count);
    normals.reserve(with_normals ? count : 0);
    for_each_record(false, [&](const Record& r) {
      const double *p = r.coordinates, *n = r.normal;
      if (!(std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]))) {
        std::ostringstream reason;
        reason << "points[" << points.size() << "] is (" << p[0] << ", " << p[1] << ", " << p[2]
               << "), but coordinates must be finite";
        throw std::runtime_error(reason.str());
      }
      points.emplace_back(p[0], p[1], p[2]);
      if (with_normals)
        normals.emplace_back(n[0], n[1], n[2]);
    });
    if (points.empty())
      throw std::runtime_error("there are no points in it");
  }
};

#endif // BALANCED_FLOW_SMOOTH_POINT_FILE_H
