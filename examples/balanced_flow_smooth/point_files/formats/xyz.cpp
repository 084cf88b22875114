// SPDX-License-Identifier: GPL-3.0-or-later
// Text with a point in each line
#include "../Raw_file.h"
#include "../write_rows.h"
#include "all_formats.h"

#include <cmath>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace point_files {

namespace {

/// Whether columns 4 to 6 are a unit vector; colors and labels are none.
bool has_unit_vector(const Line_reader& lines, const std::vector<Field>& words)
{
  double n[3];
  for (std::size_t c = 0; c < 3; ++c) {
    const char* bytes = lines.place().bytes->data();
    const auto number = words.size() < 6
                            ? std::nullopt
                            : from_text(bytes + words[c + 3].begin, bytes + words[c + 3].end);
    if (!number)
      return false;
    n[c] = *number;
  }
  return std::abs(std::hypot(n[0], n[1], n[2]) - 1.) < .01;
}

/// "x y z", then normals if all are unit vectors, and whatever else; a first line with the number
/// of points alone, if there is one.
Anatomy parse(std::string bytes)
{
  Anatomy file;
  file.bytes = std::move(bytes);
  file.first.bytes = &file.bytes;
  Line_reader lines(file.first);
  Field line;
  std::vector<Field> words;
  std::size_t width = 0;
  bool announced = false, with_normals = true;
  double announced_count = 0.;
  while (lines.next(line)) {
    lines.split(line, words);
    if (words.size() == 1 && width == 0 && !announced) {
      announced = true;
      announced_count = lines.number(words[0]);
      file.first = lines.place();
      continue;
    }
    if (words.size() < 3) {
      for (const Field& word : words)
        lines.number(word); // may tell more
      lines.fail("a point has three coordinates");
    }
    if (width != 0 && words.size() != width)
      lines.fail(std::to_string(words.size()) + " columns, but " + std::to_string(width) +
                 " before");
    width = words.size();
    with_normals = with_normals && has_unit_vector(lines, words);
    ++file.count;
  }
  if (announced && announced_count != double(file.count)) {
    std::string count;
    append_text(count, Scalar::DOUBLE, announced_count);
    throw std::runtime_error("the first line announces " + count + " points, but there are " +
                             std::to_string(file.count));
  }
  file.layout = Layout::of_columns(width, with_normals && file.count != 0);
  return file;
}

} // namespace

Format xyz_format()
{
  Format format;
  format.name = format.family = "xyz";
  format.extensions = {"pwn", "txt", "pts"};
  format.read = [](std::string bytes, bool) -> std::unique_ptr<Point_file> {
    return std::make_unique<Raw_file>(parse(std::move(bytes)));
  };
  format.write = [](const Target& target, const Point_file& file) {
    write_text_rows(target.out, file);
  };
  return format;
}

} // namespace point_files
