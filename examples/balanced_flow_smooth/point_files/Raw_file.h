// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_FILES_RAW_FILE_H
#define POINT_FILES_RAW_FILE_H

#include "Line_reader.h"
#include "Point_file.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace point_files {

enum class Encoding { TEXT, BINARY, SWAPPED_BINARY };

/// Whether numbers are bytes in the order of this machine
bool is_little_endian();

/// What the readers of the formats find out about the bytes of a file
struct Anatomy {
  std::string bytes; // all of the file
  Encoding encoding = Encoding::TEXT;
  Layout layout;
  Place first; // where the records of the points begin
  std::size_t count = 0;
  std::pair<std::size_t, std::string> normals_header; // what announces new normals, and where
  std::vector<std::string> losses;                    // what other formats can not take
};

/// A file that is kept as its bytes, of which only the numbers that change are replaced.
class Raw_file : public Point_file {
  Anatomy m_file;

public:
  explicit Raw_file(Anatomy file);
  Raw_file(const Raw_file&) = delete; // the place of the first record looks at the bytes
  Raw_file& operator=(const Raw_file&) = delete;

  void for_each_record(bool with_values, const Visitor& visit) const override;
  void write(const Target& target) const override;
  std::vector<Property> columns() const override;
  std::vector<std::string> losses() const override { return m_file.losses; }
  Scalar coordinate_type() const override { return m_file.layout.coordinate_type(); }

private:
  template <typename Function>
  void with_cursor(const Function& f) const;
  template <typename Cursor>
  const std::vector<Field>& next(Cursor& cursor, std::size_t i) const;
  template <typename Cursor>
  void go_through(Cursor& cursor, bool with_values, const Visitor& visit) const;
  std::vector<std::pair<std::size_t, std::size_t>> changing_properties() const;
  template <typename Cursor>
  void write_with(Cursor& cursor, std::ostream& out) const;
};

} // namespace point_files

#endif // POINT_FILES_RAW_FILE_H
