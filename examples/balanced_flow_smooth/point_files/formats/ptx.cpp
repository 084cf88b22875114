// SPDX-License-Identifier: GPL-3.0-or-later
// Leica's PTX: scans that are grids of points, each with the place of its scanner
#include "../Raw_stream.h"
#include "Text_parser.h"
#include "all_formats.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace point_files {

namespace {

/// Reads the lines before the points of a scan.
class Head_reader {
  Line_reader& m_lines;

public:
  explicit Head_reader(Line_reader& lines) : m_lines(lines) {}

  /// The numbers of columns and rows; the position of the scanner and its axes; the rows of a matrix
  /// that is multiplied from the right.
  /// \param line the first one, which is read already
  Block read(const Field& line)
  {
    Block scan;
    const double columns = count(numbers_of(line, 1)[0]);
    const double rows = count(numbers(1)[0]);
    if (!(columns * rows <= double(m_lines.place().bytes->size())))
      m_lines.fail("the file is too short for a scan of that size");
    scan.count = std::size_t(columns * rows);
    Scan_frame::Triple position = triple(numbers(3));
    if (columns <= 1. || rows <= 1.) // points from anywhere, not those that a scanner saw
      position.fill(std::numeric_limits<double>::quiet_NaN());
    for (int axis = 0; axis < 3; ++axis)
      numbers(3); // what they tell is in the matrix, too
    std::array<Scan_frame::Triple, 3> axes;
    for (Scan_frame::Triple& axis : axes)
      axis = triple(numbers(4));
    const Scan_frame::Triple translation = triple(numbers(4));
    scan.frame = std::make_shared<Scan_frame>(axes, translation, position);
    scan.first = m_lines.place();
    return scan;
  }

private:
  std::vector<double> numbers(std::size_t count_of_numbers)
  {
    Field line;
    if (!m_lines.next(line))
      throw std::runtime_error("the file ends in the header of a scan");
    return numbers_of(line, count_of_numbers);
  }

  std::vector<double> numbers_of(const Field& line, std::size_t count_of_numbers) const
  {
    std::vector<Field> words;
    m_lines.split(line, words);
    if (words.size() != count_of_numbers)
      m_lines.fail("the header of a PTX scan has " + std::to_string(count_of_numbers) +
                   (count_of_numbers == 1 ? " number here, not " : " numbers here, not ") +
                   std::to_string(words.size()));
    std::vector<double> numbers;
    for (const Field& word : words)
      numbers.push_back(m_lines.number(word));
    return numbers;
  }

  double count(double number) const
  {
    if (!(number >= 0. && std::floor(number) == number))
      m_lines.fail("a number of rows or columns is not a natural number");
    return number;
  }

  static Scan_frame::Triple triple(const std::vector<double>& n) { return {n[0], n[1], n[2]}; }
};

Anatomy parse(Bytes bytes, const Read_options&)
{
  Anatomy file;
  file.bytes = std::move(bytes);
  Line_reader lines(Place{&file.bytes});
  Field line;
  std::vector<Field> words;
  std::size_t width = 0;
  while (lines.next(line)) {
    file.blocks.push_back(Head_reader(lines).read(line));
    for (std::size_t i = 0; i < file.blocks.back().count; ++i) {
      if (!lines.next(line))
        throw std::runtime_error("the file ends after " + std::to_string(i) + " of " +
                                 std::to_string(file.blocks.back().count) + " points of scan " +
                                 std::to_string(file.blocks.size()));
      lines.split(line, words);
      lines.check_columns(words, width);
    }
  }
  if (width == 0)
    throw std::runtime_error("there are no points in it");
  file.layout = Layout(names_of_scan_columns(width));
  file.layout_source = "the format PTX";
  file.has_types = false;
  file.defines_invalid = file.zeros_are_invalid = true;
  file.losses = {"the grids of the scans and the places of the scanners"};
  file.obstacle_to_dropping = "each scan is a grid of points";
  return file;
}

bool begins_with_scan(const Bytes& bytes)
{
  try {
    Line_reader lines(Place{&bytes});
    Field line;
    if (!lines.next(line))
      return false;
    Head_reader(lines).read(line);
    return true;
  }
  catch (const std::runtime_error&) {
    return false;
  }
}

} // namespace

Format ptx_format()
{
  Format format;
  format.name = format.family = "ptx";
  format.recognizes = begins_with_scan;
  format.adds_normals = false;
  set_readers<parse>(format);
  format.write = [](const Target&, const Point_file&) {
    throw std::runtime_error("PTX is written from PTX only: other files have no grids of points");
  };
  return format;
}

} // namespace point_files
