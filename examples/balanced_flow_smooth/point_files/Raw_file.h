// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_FILES_RAW_FILE_H
#define POINT_FILES_RAW_FILE_H

#include "Column_types.h"
#include "Line_reader.h"
#include "Point_file.h"

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace point_files {

enum class Encoding { TEXT, BINARY, SWAPPED_BINARY };

/// Whether numbers are bytes in the order of this machine
bool is_little_endian();

/// Records one after the other
struct Block {
  Place first; // where they begin
  std::size_t count = 0;
};

/// What the readers of the formats find out about the bytes of a file
struct Anatomy {
  std::string bytes; // all of the file
  Encoding encoding = Encoding::TEXT;
  Text_style style;
  Layout layout;
  std::string layout_source; // what tells it, for people
  bool has_types = true;     // whether the layout has the types of the numbers; text has none
  std::vector<Block> blocks; // the points
  std::pair<std::size_t, std::string> normals_header; // what announces new normals, and where
  std::vector<std::string> losses;                    // what other formats can not take
};

/// A file that is kept as its bytes, of which only the numbers that change are replaced.
class Raw_file : public Point_file {
  Anatomy m_file;
  // the properties that may change, in the order of the record: 0 to 2 tell the coordinate that each
  // is, 3 to 5 that of the normal
  std::vector<std::pair<std::size_t, std::size_t>> m_changing;
  mutable std::optional<Column_types> m_columns; // of text: looked at only if they are asked for

public:
  explicit Raw_file(Anatomy file);
  Raw_file(const Raw_file&) = delete; // the places of the records look at the bytes
  Raw_file& operator=(const Raw_file&) = delete;

  void for_each_record(bool with_values, const Visitor& visit) const override;
  void write(const Target& target) const override;
  std::vector<Property> columns() const override;
  std::vector<std::string> losses() const override;
  Scalar coordinate_type() const override { return m_file.layout.coordinate_type(); }

private:
  struct Output; // what is written, and how far

  template <typename Function>
  void for_each_block(const Function& f) const;
  template <typename Cursor>
  const std::vector<Field>& next(Cursor& cursor, std::size_t i, std::size_t count) const;
  template <typename Cursor>
  void go_through(Cursor& cursor, std::size_t count, bool with_values, const Visitor& visit) const;
  template <typename Cursor>
  double length_of_normal(const Cursor& cursor, const std::vector<Field>& fields) const;
  template <typename Cursor>
  void write_record(const Cursor& cursor, const std::vector<Field>& fields, std::size_t i,
                    Output& out) const;
  const Column_types& column_types() const;
};

} // namespace point_files

#endif // POINT_FILES_RAW_FILE_H
