// SPDX-License-Identifier: GPL-3.0-or-later
// OFF as text: points, and the faces of meshes
#include "../Raw_stream.h"
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

bool is_keyword(const std::string& word)
{
  for (const char* prefix : {"", "N", "C", "CN", "ST", "STN", "STC", "STCN"})
    if (word == prefix + std::string("OFF"))
      return true;
  return false;
}

/// "OFF", with ST, C and N before it for texture coordinates, colors and normals; the numbers of
/// points, faces and edges; the points; the faces.
Anatomy parse(Bytes bytes, const Read_options&)
{
  Anatomy file;
  file.bytes = std::move(bytes);
  Line_reader lines(Place{&file.bytes});
  Field line;
  std::vector<Field> words;
  if (!lines.next(line))
    throw std::runtime_error("the file is empty");
  lines.split(line, words);
  const std::string keyword = lines.text(words[0]);
  if (!is_keyword(keyword))
    lines.fail("this is not an OFF file, or not one of points with three coordinates");
  if (words.size() > 1 && lines.text(words[1]) == "BINARY")
    lines.fail("binary OFF is not supported");
  file.normals_header = {{words[0].end - 3, "N"}};
  words.erase(words.begin());
  if (words.empty()) { // the counts stand on their own line
    if (!lines.next(line))
      lines.fail("the number of points is missing");
    lines.split(line, words);
  }
  std::size_t counts[2] = {0, 0};
  const Field count_field = words[0];
  for (std::size_t i = 0; i < 2 && i < words.size(); ++i) {
    const double count = lines.number(words[i]);
    if (!(count >= 0. && count <= double(file.bytes.size()) && std::floor(count) == count))
      lines.fail("the file is too short for " + lines.text(words[i]) +
                 (i == 0 ? " points" : " faces"));
    counts[i] = std::size_t(count);
  }
  file.blocks = {{lines.place(), counts[0], {count_field}}};

  std::size_t width = 0;
  for (std::size_t i = 0; i < counts[0]; ++i) {
    if (!lines.next(line))
      throw std::runtime_error("the file ends after " + std::to_string(i) + " of " +
                               std::to_string(counts[0]) + " points");
    lines.split(line, words);
    lines.check_columns(words, width);
  }
  const bool with_normals = keyword.find('N') != std::string::npos;
  if (with_normals && width != 0 && width < 6)
    lines.fail("the normals are missing");
  file.layout = Layout(default_names(width, with_normals));
  file.layout_source = "the keyword " + keyword;
  file.has_types = false;
  for (std::size_t i = 0; i < counts[1]; ++i)
    if (!lines.next(line))
      throw std::runtime_error("the file ends after " + std::to_string(i) + " of " +
                               std::to_string(counts[1]) + " faces");
  if (counts[1] != 0) {
    file.losses.push_back("the faces");
    file.obstacle_to_dropping = "the faces tell points by their number";
  }
  return file;
}

} // namespace

Format off_format()
{
  Format format;
  format.name = format.family = "off";
  format.columns_warning = "OFF has no names for properties, they become columns";
  format.recognizes = [](const Bytes& bytes) { return is_keyword(first_word(bytes)); };
  set_readers<parse>(format);
  format.write = [](const Target& target, const Point_file& file) {
    target.out << (file.normals.empty() ? "OFF\n" : "NOFF\n") << file.number_of_points_to_write()
               << " 0 0\n";
    write_text_rows(target.out, file);
  };
  return format;
}

} // namespace point_files
