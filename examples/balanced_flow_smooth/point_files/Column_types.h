// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_FILES_COLUMN_TYPES_H
#define POINT_FILES_COLUMN_TYPES_H

#include "Scalar.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace point_files {

/// Which types hold the numbers of columns of text
class Column_types {
  struct Column {
    bool has_reals = false, loses_digits = false;
    std::int64_t smallest = 0;
    std::uint64_t largest = 0;
  };
  std::vector<Column> m_columns;

public:
  explicit Column_types(std::size_t number_of_columns) : m_columns(number_of_columns) {}

  /// Takes in a number of a column; words that are none do not count.
  void add(std::size_t column, const std::string& word);

  /// `INT32`, `INT64` or `UINT64` if it holds them all, else `DOUBLE`
  Scalar type(std::size_t column) const;

  /// Whether there are digits that this type does not hold
  bool loses_digits(std::size_t column) const;
};

} // namespace point_files

#endif // POINT_FILES_COLUMN_TYPES_H
