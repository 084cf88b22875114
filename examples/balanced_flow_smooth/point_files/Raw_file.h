// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_FILES_RAW_FILE_H
#define POINT_FILES_RAW_FILE_H

#include "Column_types.h"
#include "Line_reader.h"
#include "Point_file.h"
#include "Record_cursor.h"
#include "Scan_frame.h"

#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <stdexcept>
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
  std::vector<Field> count_fields = {};              // where the count is in the file
  std::shared_ptr<const Scan_frame> frame = nullptr; // of a scan; null: all points share theirs
};

/// What announces new normals in a header, and where
struct Announcement {
  std::size_t place;
  std::string text;
};

/// What the readers of the formats find out about the bytes of a file
struct Anatomy {
  Bytes bytes;           // all of the file
  std::size_t begin = 0; // of those that are written
  Encoding encoding = Encoding::TEXT;
  Text_style style;
  Layout layout;
  std::string layout_source; // what tells it, for people
  bool has_types = true;     // whether the layout has the types of the numbers; text has none
  std::vector<Block> blocks; // the points
  std::vector<Announcement> normals_header;
  std::optional<Field>
      rows_field; // of a grid: where the number of rows is, 1 if points are dropped
  std::vector<std::string> losses;  // what other formats can not take
  std::string obstacle_to_dropping; // why no points may be dropped; empty if they may
  std::vector<std::string> warnings;
  bool defines_invalid = false, zeros_are_invalid = false; // see `Point_file`
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
  std::size_t end_of_bytes() const { return m_file.bytes.size(); }
  std::vector<Property> columns() const override;
  std::vector<std::string> losses() const override;
  Scalar coordinate_type() const override { return m_file.layout.coordinate_type(); }

protected:
  const Bytes& bytes() const { return m_file.bytes; }

private:
  struct Output; // what is written, and how far

  template <typename Visit>
  void for_each_fields(const Visit& visit) const;
  template <typename Cursor>
  double length_of_normal(const Cursor& cursor, const std::vector<Field>& fields) const;
  template <typename Cursor>
  Scan_frame::Triple coordinates(const Cursor& cursor, const std::vector<Field>& fields) const;
  template <typename Cursor>
  void write_record(const Cursor& cursor, const std::vector<Field>& fields, std::size_t i,
                    const Scan_frame* frame, Output& out) const;
  void write_head(const Block& block, std::size_t before, bool with_new_normals, Output& out) const;
  void drop_record(std::size_t begin, std::size_t end, Output& out) const;
  const Column_types& column_types() const;
  bool has_integer_normals() const;
  void find_sides();
  void number_scans();
};

/// Goes through the records: `visit(cursor, fields, i, block, before)`, where there are `before` points
/// before those of the block.
template <typename Visit>
void Raw_file::for_each_fields(const Visit& visit) const
{
  std::size_t before = 0;
  const auto go_through = [&](auto cursor, const Block& block) {
    for (std::size_t i = 0; i < block.count; ++i) {
      const std::vector<Field>* fields = cursor.next();
      if (!fields)
        throw std::runtime_error("the file ends after " + std::to_string(i) + " of " +
                                 std::to_string(block.count) + " points");
      visit(cursor, *fields, before + i, block, before);
    }
  };
  const std::vector<Property>& properties = m_file.layout.properties();
  for (const Block& block : m_file.blocks) {
    if (m_file.encoding == Encoding::TEXT)
      go_through(Text_cursor(block.first, properties, m_file.style), block);
    else
      go_through(
          Binary_cursor(block.first, properties, m_file.encoding == Encoding::SWAPPED_BINARY),
          block);
    before += block.count;
  }
}

/// The coordinates of a record, as they are in the file
template <typename Cursor>
Scan_frame::Triple Raw_file::coordinates(const Cursor& cursor,
                                         const std::vector<Field>& fields) const
{
  Scan_frame::Triple p;
  for (std::size_t c = 0; c < 3; ++c) {
    const std::size_t place = m_file.layout.coordinates()[c];
    p[c] = cursor.value(fields[place], m_file.layout.properties()[place].type);
  }
  return p;
}

/// How long the normal of a record is in the file: integers stand for a unit vector in some scale.
template <typename Cursor>
double Raw_file::length_of_normal(const Cursor& cursor, const std::vector<Field>& fields) const
{
  double n[3];
  for (std::size_t c = 0; c < 3; ++c) {
    const std::size_t p = m_file.layout.normals()[c];
    n[c] = cursor.value(fields[p], m_file.layout.properties()[p].type);
  }
  return std::hypot(n[0], n[1], n[2]);
}

} // namespace point_files

#endif // POINT_FILES_RAW_FILE_H
