// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_FILES_PLY_HEADER_H
#define POINT_FILES_PLY_HEADER_H

#include "../Raw_file.h"

#include <cstddef>
#include <istream>
#include <string>
#include <vector>

namespace point_files {

/// Records of one kind, as the header announces them
struct Ply_element {
  std::string name;
  std::size_t count = 0;
  Field count_field = {0, 0}; // where it is in the header
  std::vector<Property> properties;
  std::vector<std::size_t> property_ends; // where their lines end in the header

  bool has_points() const { return name == "vertex" || name == "vertices"; }

  bool has_lists() const;
  std::size_t fixed_size() const; // of a record without lists
};

/// The header of a PLY file
struct Ply_header {
  Encoding encoding = Encoding::TEXT;
  std::vector<Ply_element> elements;
  std::string end_of_line = "\n";
  std::size_t end = 0, number_of_lines = 0;

  /// Throws `std::runtime_error` if the bytes begin with none.
  explicit Ply_header(const Bytes& bytes);

private:
  void read_format(const std::string& line, std::istream& words);
  void read_element(const std::string& line, std::size_t line_begin, std::size_t file_size);
  void read_property(const std::string& line, std::istream& words);
};

} // namespace point_files

#endif // POINT_FILES_PLY_HEADER_H
