// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef COMPARISON_RESULT_TABLE_H
#define COMPARISON_RESULT_TABLE_H

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace comparison {

/// Rows of named numbers. What is not known is NaN; columns with nothing else are left out.
class Result_table {
  std::vector<std::string> m_columns;
  std::vector<std::pair<std::string, std::vector<double>>> m_rows;

  static std::string text(double value, const char* unknown)
  {
    std::ostringstream out;
    out << std::setprecision(4) << value;
    return std::isnan(value) ? unknown : out.str();
  }

  bool is_used(std::size_t column) const
  {
    return std::any_of(m_rows.begin(), m_rows.end(),
                       [&](const auto& row) { return !std::isnan(row.second[column]); });
  }

public:
  typedef std::vector<std::pair<std::string, double>> Named_numbers;

  void add(const std::string& name, const Named_numbers& numbers)
  {
    m_columns.clear();
    m_rows.push_back({name, {}});
    for (const auto& number : numbers) {
      m_columns.push_back(number.first);
      m_rows.back().second.push_back(number.second);
    }
  }

  /// The names of the columns that are not left out
  std::vector<std::string> columns() const
  {
    std::vector<std::string> used;
    for (std::size_t c = 0; c < m_columns.size(); ++c)
      if (is_used(c))
        used.push_back(m_columns[c]);
    return used;
  }

  /// Calls `visit` with the name of each row and its numbers in `columns()`.
  template <typename Visit>
  void for_each_row(const Visit& visit) const
  {
    for (const auto& row : m_rows) {
      std::vector<double> numbers;
      for (std::size_t c = 0; c < m_columns.size(); ++c)
        if (is_used(c))
          numbers.push_back(row.second[c]);
      visit(row.first, numbers);
    }
  }

  /// Calls `write_row` with the texts of the head and of each row.
  template <typename Write_row>
  void for_each_line(const char* unknown, const Write_row& write_row) const
  {
    std::vector<std::string> line = columns();
    line.insert(line.begin(), "method");
    write_row(line);
    for_each_row([&](const std::string& name, const std::vector<double>& numbers) {
      line = {name};
      for (const double number : numbers)
        line.push_back(text(number, unknown));
      write_row(line);
    });
  }

  /// Not known is an empty field, which spreadsheets understand.
  void write_csv(std::ostream& out) const
  {
    for_each_line("", [&](const std::vector<std::string>& line) {
      for (std::size_t i = 0; i < line.size(); ++i)
        out << (i == 0 ? "\"" : ",\"") << line[i] << '"';
      out << '\n';
    });
  }

  /// Padded, so that it reads well as plain text, too
  void write_markdown(std::ostream& out) const
  {
    std::vector<std::size_t> widths(m_columns.size() + 1, 3);
    for_each_line("-", [&](const std::vector<std::string>& line) {
      for (std::size_t i = 0; i < line.size(); ++i)
        widths[i] = (std::max)(widths[i], line[i].size());
    });
    bool first = true;
    for_each_line("-", [&](const std::vector<std::string>& line) {
      for (std::size_t i = 0; i < line.size(); ++i)
        out << (i == 0 ? "| " : " | ") << (i == 0 ? std::left : std::right)
            << std::setw(int(widths[i])) << line[i];
      out << " |\n";
      for (std::size_t i = 0; first && i < line.size(); ++i)
        out << (i == 0 ? "|:" : "|-") << std::string(widths[i], '-') << (i == 0 ? "-" : ":");
      out << (first ? "|\n" : "");
      first = false;
    });
  }
};

} // namespace comparison

#endif // COMPARISON_RESULT_TABLE_H
