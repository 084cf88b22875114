// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_FILES_LAS_NEW_LAS_H
#define POINT_FILES_LAS_NEW_LAS_H

#include "../../Point_file.h"
#include "Fields.h"
#include "Header.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace point_files::las {

/// The points, normals and columns of a file of another format as LAS 1.4. Columns with the name and
/// values of a field of LAS become that field, all others and normals become extra bytes.
class New_las {
  const Point_file& m_file;
  Grid m_grid = {};
  std::array<double, 3> m_min, m_max;
  std::vector<std::uint64_t> m_returns = std::vector<std::uint64_t>(15); // points of each
  unsigned m_point_format = 6;
  std::size_t m_record_size = 0;
  std::vector<Field> m_columns; // where each goes
  std::vector<Field> m_normals;
  std::vector<Field> m_extra; // those of both that are extra bytes
  bool m_has_returns = false; // else each point is the only one

public:
  /// Throws `std::runtime_error` if the file does not fit into LAS.
  explicit New_las(const Point_file& file);

  void write(const Target& target) const;

private:
  void choose_grid();
  void choose_fields();
  void find_bounds();
  Field add_extra(const std::string& name, Scalar type);
  std::string header() const;
  std::string extra_bytes_record() const;
  void fill(std::string& bytes, const Record& record, std::size_t i) const;
};

} // namespace point_files::las

#endif // POINT_FILES_LAS_NEW_LAS_H
