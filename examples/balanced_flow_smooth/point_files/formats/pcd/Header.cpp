// SPDX-License-Identifier: GPL-3.0-or-later
#include "Header.h"

#include "lzf.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <system_error>

namespace point_files::pcd {

namespace {

constexpr const char* keywords[] = {"VERSION", "FIELDS", "COLUMNS",   "SIZE",   "TYPE", "COUNT",
                                    "WIDTH",   "HEIGHT", "VIEWPOINT", "POINTS", "DATA"};
constexpr const char* versions[] = {".5", ".6", ".7", "0.5", "0.6", "0.7"};

template <typename Words>
bool has(const Words& words, const std::string& word)
{
  return std::find(std::begin(words), std::end(words), word) != std::end(words);
}

} // namespace

Header::Header(const Bytes& bytes) : m_bytes(&bytes)
{
  read_lines();
  read_fields();
  check_types();
  read_points();
  read_viewpoint();
}

/// Reads up to the line DATA.
void Header::read_lines()
{
  // bytes behind the header may look like the second half of a line end, so the first line decides
  const std::size_t first_end = m_bytes->find_first_of("\r\n");
  const bool ends_with_cr = first_end != std::string::npos && (*m_bytes)[first_end] == '\r' &&
                            m_bytes->compare(first_end, 2, "\r\n") != 0;
  Line_reader lines(Place{m_bytes});
  Field line;
  std::vector<Field> words;
  while (m_lines.count("DATA") == 0) {
    if (!lines.next(line))
      throw std::runtime_error(m_lines.empty() ? "this is not a PCD file"
                                               : "the file ends in the header, before DATA");
    lines.split(line, words);
    const std::string keyword = lines.text(words[0]);
    if (!has(keywords, keyword))
      lines.fail(m_lines.empty() ? "this is not a PCD file, which begins with VERSION"
                                 : "\"" + keyword + "\" is not known in the header of a PCD file");
    words.erase(words.begin());
    const std::string name = keyword == "COLUMNS" ? "FIELDS" : keyword; // as it was called first
    if (!m_lines.emplace(name, Line{lines.place().line, words}).second)
      lines.fail("a second line " + keyword);
    end = lines.place();
    if (ends_with_cr)
      end.at = line.end == m_bytes->size() ? line.end : m_bytes->find('\r', line.begin) + 1;
  }
  const Line& version = get("VERSION", 1);
  if (!has(versions, text(version.words[0])))
    fail(version, "VERSION " + text(version.words[0]) + " of PCD is not known (.5 to .7)");
  const Line& how = get("DATA", 1);
  const std::string name = text(how.words[0]);
  if (name == "binary")
    data = Data::BINARY;
  else if (name == "binary_compressed")
    data = Data::COMPRESSED;
  else if (name != "ascii")
    fail(how, "DATA " + name + " is not known (ascii, binary, binary_compressed)");
}

void Header::read_fields()
{
  const Line* const names = find("FIELDS");
  if (!names || names->words.empty())
    throw std::runtime_error("the header has no FIELDS");
  const std::size_t width = names->words.size();
  const Line &sizes = get("SIZE", width), &types = get("TYPE", width);
  const Line* const counts = find("COUNT") ? &get("COUNT", width) : nullptr;
  for (std::size_t i = 0; i < width; ++i) {
    Value_field& field = fields.emplace_back();
    field.name = text(names->words[i]);
    field.size = natural_number(sizes, i);
    const std::string type = text(types.words[i]);
    if (type != "I" && type != "U" && type != "F")
      fail(types, "TYPE " + type + " of " + field.name + " is not known (I, U, F)");
    field.type = type[0];
    if (!counts)
      continue;
    field.count = natural_number(*counts, i);
    if (field.count == 0)
      fail(*counts, "COUNT of " + field.name + " is 0");
    if (field.count != 1 && !role_of(field.name).empty())
      fail(*counts, "COUNT of " + field.name + " is " + text(counts->words[i]) +
                        ", but coordinates and normals are single numbers");
  }
}

/// Padding may have any type.
void Header::check_types() const
{
  const std::size_t largest = m_bytes->size() * (data == Data::COMPRESSED ? largest_lzf_ratio : 1);
  std::size_t all = 0;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const Value_field& field = fields[i];
    const std::size_t s = field.size;
    const bool is_known = s == 8 || s == 4 || (field.type != 'F' && (s == 2 || s == 1));
    if (s == 0 || (!is_known && !field.is_padding()))
      fail(m_lines.at("SIZE"), "SIZE " + std::to_string(s) + " of " + field.name +
                                   " is not known for TYPE " + field.type);
    if (s > largest || field.count > largest || (all += field.width()) > largest)
      throw std::runtime_error("the file is too short for " + std::to_string(field.count) +
                               " values of " + field.name);
  }
}

void Header::read_points()
{
  std::optional<std::size_t> width, points;
  if (const Line* const line = find("HEIGHT")) {
    rows = natural_number(get("HEIGHT", 1), 0);
    rows_place = line->words[0];
  }
  if (const Line* const line = find("WIDTH")) {
    width = natural_number(get("WIDTH", 1), 0);
    count_places.push_back(line->words[0]);
  }
  if (const Line* const line = find("POINTS")) {
    points = natural_number(get("POINTS", 1), 0);
    count_places.push_back(line->words[0]);
  }
  if (!width && !points)
    throw std::runtime_error("the header has neither WIDTH nor POINTS");
  const bool is_too_large =
      width && rows != 0 && *width > (std::numeric_limits<std::size_t>::max)() / rows;
  if (!width)
    rows = 1, rows_place.reset();
  if (width && points && (is_too_large || *width * rows != *points))
    fail(*find("POINTS"), "POINTS " + std::to_string(*points) + " is not WIDTH " +
                              std::to_string(*width) + " times HEIGHT " + std::to_string(rows));
  if (is_too_large)
    fail(*find("WIDTH"), "the file is too short for WIDTH " + std::to_string(*width) +
                             " times HEIGHT " + std::to_string(rows));
  count = points ? *points : *width * rows;
}

void Header::read_viewpoint()
{
  if (!find("VIEWPOINT"))
    return;
  const Line& line = get("VIEWPOINT", 7);
  for (std::size_t i = 0; i < line.words.size(); ++i) {
    const Field& word = line.words[i];
    const auto number = from_text(m_bytes->data() + word.begin, m_bytes->data() + word.end);
    if (!number)
      fail(line, "\"" + text(word) + "\" is not a number");
    if (i < 3)
      viewpoint[i] = *number;
  }
}

std::size_t Header::record_size() const
{
  std::size_t size = 0;
  for (const Value_field& field : fields)
    size += field.width();
  return size;
}

void Header::leave_out_padding()
{
  leaves_out_padding = true;
  for (Value_field& field : fields)
    if (field.is_padding())
      field.size = 0;
}

std::vector<Announcement> Header::announce_normals(std::size_t field, Scalar type) const
{
  const auto is_normal = [](const Value_field& f) { return role_of(f.name)[0] == 'n'; };
  const bool is_taken = std::any_of(fields.begin(), fields.end(), is_normal);
  std::vector<Announcement> all;
  const auto announce = [&](const std::string& keyword, const std::string& words) {
    if (const Line* const line = find(keyword))
      all.push_back({line->words[field].end, words});
  };
  const std::string size = " " + std::to_string(size_of(type));
  announce("FIELDS", is_taken ? " nx ny nz" : " normal_x normal_y normal_z");
  announce("SIZE", size + size + size);
  announce("TYPE", " F F F");
  announce("COUNT", " 1 1 1");
  return all;
}

/// The line of that keyword, or null
const Header::Line* Header::find(const std::string& keyword) const
{
  const auto found = m_lines.find(keyword);
  return found != m_lines.end() ? &found->second : nullptr;
}

const Header::Line& Header::get(const std::string& keyword, std::size_t number_of_words) const
{
  const Line* const line = find(keyword);
  if (!line)
    throw std::runtime_error("the header has no " + keyword);
  if (line->words.size() != number_of_words)
    fail(*line, keyword + " has " + std::to_string(line->words.size()) + " values, not " +
                    std::to_string(number_of_words));
  return *line;
}

std::string Header::text(const Field& word) const
{
  return m_bytes->substr(word.begin, word.end - word.begin);
}

std::size_t Header::natural_number(const Line& line, std::size_t i) const
{
  const Field& word = line.words[i];
  const char* const last = m_bytes->data() + word.end;
  std::size_t number = 0;
  const auto parsed = std::from_chars(m_bytes->data() + word.begin, last, number);
  if (parsed.ptr != last || parsed.ec != std::errc())
    fail(line, "\"" + text(word) + "\" is not a natural number");
  return number;
}

void Header::fail(const Line& line, const std::string& reason)
{
  throw std::runtime_error("line " + std::to_string(line.number) + ": " + reason);
}

} // namespace point_files::pcd
