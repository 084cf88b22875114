// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_FILES_PCD_HEADER_H
#define POINT_FILES_PCD_HEADER_H

#include "../../Line_reader.h"
#include "../../Raw_file.h"

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace point_files::pcd {

/// A field of the header: one value of each point, or several of one type
struct Value_field {
  std::string name;
  char type = 'F'; // I, U or F
  std::size_t size = 4, count = 1;

  bool is_padding() const { return name == "_"; }
  std::size_t width() const { return size * count; } // in bytes
};

/// How the points are stored
enum class Data { ASCII, BINARY, COMPRESSED };

/// The header of a PCD file
class Header {
public:
  std::vector<Value_field> fields;
  bool leaves_out_padding = false; // whether it has no bytes
  std::size_t count = 0, rows = 1;
  Data data = Data::ASCII;
  std::array<double, 3> viewpoint = {0., 0., 0.}; // where the scanner was
  Place end;                                      // where the points begin

  std::vector<Field> count_places; // where the header has the number of points
  std::optional<Field> rows_place;

  /// Throws `std::runtime_error` if the bytes begin with none. They are not looked at afterwards.
  explicit Header(const Bytes& bytes);

  /// whether the points are a grid that can be taken for the image of a scanner
  bool is_image() const { return rows > 1 && count > rows; }

  std::size_t record_size() const; // in bytes

  /// Padding may be left out where the points are compressed.
  void leave_out_padding();

  /// What announces new normals of a type behind the field of that number.
  std::vector<Announcement> announce_normals(std::size_t field, Scalar type) const;

private:
  /// A line of the header: the words after the first
  struct Line {
    std::size_t number;
    std::vector<Field> words;
  };
  const Bytes* m_bytes;
  std::map<std::string, Line> m_lines; // by their first words

  void read_lines();
  void read_fields();
  void read_points();
  void read_viewpoint();
  void check_types() const;
  const Line* find(const std::string& keyword) const;
  const Line& get(const std::string& keyword, std::size_t number_of_words) const;
  std::string text(const Field& word) const;
  std::size_t natural_number(const Line& line, std::size_t i) const;
  [[noreturn]] static void fail(const Line& line, const std::string& reason);
};

} // namespace point_files::pcd

#endif // POINT_FILES_PCD_HEADER_H
