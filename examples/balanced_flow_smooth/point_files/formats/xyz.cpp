// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_SMOOTH_READ_TEXT_H
#define BALANCED_FLOW_SMOOTH_READ_TEXT_H

#include "Raw_file.h"

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

/// Whether columns 4 to 6 are a unit vector; colors and labels are none.
inline bool has_unit_vector(const Line_reader& lines, const std::vector<Field>& words)
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
inline Anatomy read_xyz(std::string bytes)
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

/// "OFF", with ST, C and N before it for texture coordinates, colors and normals; the numbers of
/// points, faces and edges; the points; the faces.
inline Anatomy read_off(std::string bytes)
{
  Anatomy file;
  file.bytes = std::move(bytes);
  file.first.bytes = &file.bytes;
  Line_reader lines(file.first);
  Field line;
  std::vector<Field> words;
  const auto text = [&](const Field& word) {
    return file.bytes.substr(word.begin, word.end - word.begin);
  };
  if (!lines.next(line))
    throw std::runtime_error("the file is empty");
  lines.split(line, words);
  const std::string keyword = text(words[0]);
  const bool is_known = [&] {
    for (const char* prefix : {"", "N", "C", "CN", "ST", "STN", "STC", "STCN"})
      if (keyword == prefix + std::string("OFF"))
        return true;
    return false;
  }();
  if (!is_known)
    lines.fail("this is not an OFF file, or not one of points with three coordinates");
  if (words.size() > 1 && text(words[1]) == "BINARY")
    lines.fail("binary OFF is not supported");
  file.normals_header = {words[0].end - 3, "N"};
  words.erase(words.begin());
  if (words.empty()) { // the counts stand on their own line
    if (!lines.next(line))
      lines.fail("the number of points is missing");
    lines.split(line, words);
  }
  std::size_t counts[2] = {0, 0};
  for (std::size_t i = 0; i < 2 && i < words.size(); ++i) {
    const double count = lines.number(words[i]);
    if (!(count >= 0. && count <= double(file.bytes.size()) && std::floor(count) == count))
      lines.fail("the file is too short for " + text(words[i]) + (i == 0 ? " points" : " faces"));
    counts[i] = std::size_t(count);
  }
  file.count = counts[0];
  file.first = lines.place();

  std::size_t width = 0;
  for (std::size_t i = 0; i < file.count; ++i) {
    if (!lines.next(line))
      throw std::runtime_error("the file ends after " + std::to_string(i) + " of " +
                               std::to_string(file.count) + " points");
    lines.split(line, words);
    if (words.size() < 3)
      lines.fail("a point has three coordinates");
    if (width != 0 && words.size() != width)
      lines.fail(std::to_string(words.size()) + " columns, but " + std::to_string(width) +
                 " before");
    width = words.size();
  }
  const bool with_normals = keyword.find('N') != std::string::npos;
  if (with_normals && width != 0 && width < 6)
    lines.fail("the normals are missing");
  file.layout = Layout::of_columns(width, with_normals);
  for (std::size_t i = 0; i < counts[1]; ++i)
    if (!lines.next(line))
      throw std::runtime_error("the file ends after " + std::to_string(i) + " of " +
                               std::to_string(counts[1]) + " faces");
  if (counts[1] != 0)
    file.losses.push_back("the faces");
  return file;
}

#endif // BALANCED_FLOW_SMOOTH_READ_TEXT_H
