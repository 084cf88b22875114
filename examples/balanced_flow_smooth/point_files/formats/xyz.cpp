// SPDX-License-Identifier: GPL-3.0-or-later
// Text with a point in each line: one reader, and formats that differ in what they mean and write
#include "../Raw_file.h"
#include "../write_rows.h"
#include "Text_head.h"
#include "all_formats.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace point_files {

namespace {

typedef std::vector<std::string> Names;

/// Finds out whether columns 4 to 6 look like normals: unit vectors, and some that are not known.
class Normals_guess {
  bool m_are_possible = true, m_is_any_known = false;

public:
  void add(const Line_reader& lines, const std::vector<Field>& words)
  {
    double n[3];
    for (std::size_t c = 0; c < 3 && m_are_possible; ++c) {
      const char* bytes = lines.place().bytes->data();
      const auto number = words.size() < 6
                              ? std::nullopt
                              : from_text(bytes + words[c + 3].begin, bytes + words[c + 3].end);
      m_are_possible = number.has_value();
      n[c] = number.value_or(0.);
    }
    if (!m_are_possible)
      return;
    const double length = std::hypot(n[0], n[1], n[2]);
    const bool is_unit = std::abs(length - 1.) < .01;
    m_is_any_known = m_is_any_known || is_unit;
    m_are_possible = is_unit || length == 0. || std::isnan(length);
  }

  bool operator()() const { return m_are_possible && m_is_any_known; }
};

/// The points of a text, in blocks that may begin with their number
class Text_parser {
  Anatomy m_file;
  Text_head m_head;
  std::size_t m_width = 0, m_count = 0;
  std::optional<double> m_announced; // by a line before the block
  std::size_t m_announcement = 0;    // the number of that line
  Normals_guess m_normals;

public:
  Text_parser(std::string bytes, const Names& columns)
  {
    m_file.bytes = std::move(bytes);
    m_head = read_text_head(m_file.bytes, columns);
    m_file.style.separator = m_head.separator;
    m_file.has_types = false;
  }

  /// \param names those of the columns if nothing tells them, for a number of columns
  Anatomy parse(Names (*names)(std::size_t))
  {
    Line_reader lines(Place{&m_file.bytes}, m_head.separator);
    m_file.blocks.push_back({lines.place(), 0});
    Field line;
    std::vector<Field> words;
    while (lines.next(line)) {
      lines.split(line, words);
      if (lines.place().line == m_head.header_line)
        m_file.blocks.back().first = lines.place();
      else if (words.size() == 1 && (m_count == 0 || m_announced))
        begin_block(lines, words[0]);
      else
        add_point(lines, words);
    }
    end_block();
    if (m_file.blocks.size() > 1)
      m_file.losses.push_back("the division into scans");
    set_layout(names);
    return std::move(m_file);
  }

  bool has_unnamed_normals() const { return m_head.source.empty() && m_normals(); }

private:
  void begin_block(const Line_reader& lines, const Field& word)
  {
    const double number = lines.number(word);
    end_block();
    m_announced = number;
    m_announcement = lines.place().line;
    if (m_file.blocks.back().count != 0)
      m_file.blocks.emplace_back();
    m_file.blocks.back().first = lines.place();
  }

  void end_block() const
  {
    const std::size_t count = m_file.blocks.back().count;
    if (!m_announced || *m_announced == double(count))
      return;
    std::string announced;
    append_text(announced, Scalar::DOUBLE, *m_announced);
    throw std::runtime_error("line " + std::to_string(m_announcement) + " announces " + announced +
                             " points, but there are " + std::to_string(count));
  }

  void add_point(const Line_reader& lines, const std::vector<Field>& words)
  {
    if (words.size() < 3) {
      for (const Field& word : words)
        lines.number(word); // may tell more
      lines.fail("a point has three coordinates");
    }
    if (m_width != 0 && words.size() != m_width)
      lines.fail(std::to_string(words.size()) + " columns, but " + std::to_string(m_width) +
                 " before");
    m_width = words.size();
    m_normals.add(lines, words);
    ++m_file.blocks.back().count;
    ++m_count;
  }

  void set_layout(Names (*default_names_of)(std::size_t))
  {
    if (m_count == 0)
      m_width = 3; // there is nothing to find
    Names names = m_head.names.empty() ? default_names_of(m_width) : m_head.names;
    if (names.size() > m_width)
      throw std::runtime_error(std::to_string(names.size()) + " names of columns, but there are " +
                               std::to_string(m_width) + " columns");
    for (std::size_t i = 0; i < m_width; ++i) {
      if (i == names.size())
        names.emplace_back();
      const std::string role = role_of(names[i]);
      const auto end = names.begin() + std::ptrdiff_t(i);
      if (!role.empty())
        names[i] = role;
      else if (names[i].empty() || names[i] == "_")
        names[i] = "column_" + std::to_string(i + 1);
      else if (std::find(names.begin(), end, names[i]) != end) // names may be used once only
        names[i] += "_" + std::to_string(i + 1);
    }
    m_file.layout = Layout(names);
    m_file.layout_source = m_head.source;
    const std::size_t last = m_file.layout.last_coordinate();
    if (last >= m_head.name_fields.size())
      return;
    std::size_t end = m_head.name_fields[last].end;
    if (end < m_file.bytes.size() && m_file.bytes[end] == '"')
      ++end;
    m_file.normals_header.first = end;
    for (const char* name : {"nx", "ny", "nz"})
      m_file.normals_header.second += m_head.name_separator + std::string(name);
  }
};

std::unique_ptr<Point_file> read_text(std::string bytes, const Names& columns,
                                      Names (*names)(std::size_t), const std::string& source)
{
  Text_parser parser(std::move(bytes), columns);
  Anatomy anatomy = parser.parse(names);
  if (anatomy.layout_source.empty())
    anatomy.layout_source = source;
  auto file = std::make_unique<Raw_file>(std::move(anatomy));
  if (parser.has_unnamed_normals() && file->normals.empty())
    file->warnings.push_back("columns 4 to 6 look like normals, but nothing says that they are, so "
                             "they are kept: --columns x,y,z,nx,ny,nz would smooth them, too");
  return file;
}

Names points_first(std::size_t width) { return default_names(width, false); }

Names normals_after_points(std::size_t width)
{
  if (width < 6)
    throw std::runtime_error("PWN has normals in columns 4 to 6, but there are " +
                             std::to_string(width) + " columns (--format xyz reads points alone)");
  return default_names(width, true);
}

/// Leica's PTS has an intensity, a color, or both.
Names names_of_pts(std::size_t width)
{
  Names names = {"x", "y", "z"};
  if (width == 4 || width == 7)
    names.push_back("intensity");
  if (width == 6 || width == 7)
    names.insert(names.end(), {"red", "green", "blue"});
  return names.size() == width ? names : default_names(width, false);
}

template <Names (*names)(std::size_t)>
Format text_format(const char* name)
{
  Format format;
  format.name = format.family = name;
  format.has_columns = true;
  format.read = [](std::string bytes, const Read_options& options) {
    return read_text(std::move(bytes), options.columns, names, "their order");
  };
  return format;
}

} // namespace

Format xyz_format()
{
  Format format = text_format<points_first>("xyz");
  format.extensions = {"txt", "asc"};
  format.write = [](const Target& target, const Point_file& file) {
    if (!file.normals.empty() || !file.columns().empty()) // three columns are clear
      target.out << "# " << names_of_rows(file) << '\n';
    write_text_rows(target.out, file);
  };
  return format;
}

Format csv_format()
{
  Format format = text_format<points_first>("csv");
  format.write = [](const Target& target, const Point_file& file) {
    target.out << names_of_rows(file, ',') << '\n';
    write_text_rows(target.out, file, ',');
  };
  return format;
}

Format pts_format()
{
  Format format = text_format<names_of_pts>("pts");
  format.columns_warning = "PTS has no names for properties, they become columns";
  format.write = [](const Target& target, const Point_file& file) {
    if (!file.normals.empty()) // they would pass for colors
      target.out << "# " << names_of_rows(file) << '\n';
    target.out << file.points.size() << '\n';
    write_text_rows(target.out, file);
  };
  return format;
}

Format pwn_format()
{
  Format format = text_format<normals_after_points>("pwn");
  format.extensions = {"xyzn"};
  format.columns_warning = "PWN has no names for properties, they become columns";
  format.write = [](const Target& target, const Point_file& file) {
    if (file.normals.empty())
      throw std::runtime_error("PWN is for points with normals: --normals adds them");
    write_text_rows(target.out, file);
  };
  return format;
}

} // namespace point_files
