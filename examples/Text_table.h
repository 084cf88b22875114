// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_EXAMPLES_TEXT_TABLE_H
#define BALANCED_FLOW_EXAMPLES_TEXT_TABLE_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Point_set_3.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <istream>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <typeindex>
#include <utility>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Point_set_3<Kernel::Point_3> Point_set;

// Points as lines of numbers, "x y z ...", as in XYZ and OFF files. CGAL's readers drop what comes
// after the normal; here each further column becomes a property "column_4", "column_5", ...

/// Reads lines of text and knows where it is
class Line_reader {
  std::istream& m_in;
  std::size_t m_number = 0;

public:
  explicit Line_reader(std::istream& in) : m_in(in) {}

  /// the next line with something in it, without comments
  bool next(std::string& line)
  {
    while (std::getline(m_in, line)) {
      ++m_number;
      line.erase((std::min)(line.find('#'), line.size()));
      if (line.find_first_not_of(" \t\r") != std::string::npos)
        return true;
    }
    return false;
  }

  [[noreturn]] void fail(const std::string& reason) const
  {
    throw std::runtime_error("line " + std::to_string(m_number) + ": " + reason);
  }

  /// appends the numbers of a line to a vector
  void parse(const std::string& line, std::vector<double>& numbers) const
  {
    const char *at = line.data(), *end = at + line.size();
    const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
    for (;;) {
      while (at != end && blank(*at))
        ++at;
      if (at == end)
        return;
      if (*at == '+')
        ++at;
      double number = 0.;
      const auto parsed = std::from_chars(at, end, number);
      if (parsed.ec == std::errc::result_out_of_range) // 1e-400 is 0 and no error
        number = std::strtod(std::string(at, parsed.ptr).c_str(), nullptr);
      if (parsed.ptr == at || (parsed.ptr != end && !blank(*parsed.ptr)))
        fail("\"" + std::string(at, std::find_if(at, end, blank)) + "\" is not a number");
      numbers.push_back(number);
      at = parsed.ptr;
    }
  }
};

/// Rows of equally many numbers
struct Text_table {
  std::size_t width = 0;
  std::vector<double> numbers;

  std::size_t rows() const { return width == 0 ? 0 : numbers.size() / width; }

  void add(const std::string& line, const Line_reader& reader)
  {
    const std::size_t before = numbers.size();
    reader.parse(line, numbers);
    const std::size_t found = numbers.size() - before;
    if (found < 3)
      reader.fail("a point has three coordinates");
    if (width != 0 && found != width)
      reader.fail(std::to_string(found) + " columns, but " + std::to_string(width) + " before");
    width = found;
  }

  /// whether columns 4 to 6 are unit vectors in all rows; colours and labels are not
  bool has_normals() const
  {
    for (std::size_t i = 0; i < numbers.size(); i += width)
      if (width < 6 ||
          !(std::abs(std::hypot(numbers[i + 3], numbers[i + 4], numbers[i + 5]) - 1.) < .01))
        return false;
    return rows() != 0;
  }

  void move_to(Point_set& points, bool with_normals) const
  {
    if (with_normals)
      points.add_normal_map();
    const std::size_t first = with_normals ? 6 : 3;
    std::vector<Point_set::Property_map<double>> columns;
    for (std::size_t c = first; c < width; ++c)
      columns.push_back(
          points.add_property_map<double>("column_" + std::to_string(c + 1), 0.).first);
    points.reserve(rows());
    for (std::size_t i = 0; i < numbers.size(); i += width) {
      const Point_set::iterator point = points.insert({numbers[i], numbers[i + 1], numbers[i + 2]});
      if (with_normals)
        points.normal(*point) = {numbers[i + 3], numbers[i + 4], numbers[i + 5]};
      for (std::size_t c = first; c < width; ++c)
        columns[c - first][*point] = numbers[i + c];
    }
  }
};

/// The shortest text that reads back as the same number
template <typename Number>
std::string to_text(Number number)
{
  char text[64];
  return std::string(text, std::to_chars(text, text + sizeof text, number).ptr);
}

/// Writes the numeric properties of a point set as columns of text.
class Column_writer {
  typedef Point_set::Index Index;
  std::vector<std::pair<std::string, std::function<std::string(Index)>>> m_columns;

  template <typename T>
  void add_if(Point_set& points, const std::pair<std::string, std::type_index>& property)
  {
    if (property.second != typeid(T))
      return;
    const auto map =
        points.add_property_map<T>(property.first).first; // it exists: only looks it up
    // to_chars writes characters as letters: promote
    m_columns.emplace_back(property.first, [map](Index i) { return to_text(+map[i]); });
  }

public:
  explicit Column_writer(Point_set& points)
  {
    for (const auto& property : points.properties_and_types()) {
      add_if<std::int8_t>(points, property), add_if<std::uint8_t>(points, property);
      add_if<std::int16_t>(points, property), add_if<std::uint16_t>(points, property);
      add_if<std::int32_t>(points, property), add_if<std::uint32_t>(points, property);
      add_if<std::int64_t>(points, property), add_if<std::uint64_t>(points, property);
      add_if<float>(points, property), add_if<double>(points, property);
    }
  }

  const auto& columns() const { return m_columns; }

  void write(std::ostream& out, const Point_set& points) const
  {
    for (const Index& i : points) {
      const Kernel::Point_3& p = points.point(i);
      out << to_text(p.x()) << ' ' << to_text(p.y()) << ' ' << to_text(p.z());
      if (points.has_normal_map()) {
        const Kernel::Vector_3& n = points.normal(i);
        out << ' ' << to_text(n.x()) << ' ' << to_text(n.y()) << ' ' << to_text(n.z());
      }
      for (const auto& column : m_columns)
        out << ' ' << column.second(i);
      out << '\n';
    }
  }
};

#endif // BALANCED_FLOW_EXAMPLES_TEXT_TABLE_H
