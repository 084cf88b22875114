// SPDX-License-Identifier: GPL-3.0-or-later
#include "Column_types.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <optional>

namespace point_files {

namespace {

/// How many digits there are from the first to the last that is not 0, without the exponent
int significant_digits(const std::string& word)
{
  int digits = 0, zeros = 0;
  for (const char c : word) {
    if (c == 'e' || c == 'E')
      break;
    if (!std::isdigit(static_cast<unsigned char>(c)))
      continue;
    if (c == '0')
      zeros += digits != 0;
    else
      digits += zeros + 1, zeros = 0;
  }
  return digits;
}

bool fits_double(std::uint64_t number) { return number <= std::uint64_t(1) << 53; }

} // namespace

void Column_types::add(std::size_t i, const std::string& word)
{
  Column& column = m_columns[i];
  const std::optional<Number> number = number_from_text(word.data(), word.data() + word.size());
  if (!number)
    return;
  if (const auto* real = std::get_if<double>(&*number)) {
    column.has_reals = true;
    // a double has 17 digits if it was written as one
    column.loses_digits =
        column.loses_digits || (std::isfinite(*real) && significant_digits(word) > 17);
  }
  else if (const auto* integer = std::get_if<std::int64_t>(&*number)) {
    column.smallest = (std::min)(column.smallest, *integer);
    column.largest =
        (std::max)(column.largest, std::uint64_t((std::max)(*integer, std::int64_t(0))));
  }
  else
    column.largest = (std::max)(column.largest, std::get<std::uint64_t>(*number));
}

Scalar Column_types::type(std::size_t i) const
{
  const Column& column = m_columns[i];
  const auto largest = [](auto type) {
    return std::uint64_t((std::numeric_limits<decltype(type)>::max)());
  };
  if (column.has_reals || (column.smallest < 0 && column.largest > largest(std::int64_t())))
    return Scalar::DOUBLE;
  if (column.largest > largest(std::int64_t()))
    return Scalar::UINT64;
  return column.smallest >= (std::numeric_limits<std::int32_t>::min)() &&
                 column.largest <= largest(std::int32_t())
             ? Scalar::INT32
             : Scalar::INT64;
}

bool Column_types::loses_digits(std::size_t i) const
{
  const Column& column = m_columns[i];
  return column.loses_digits || (type(i) == Scalar::DOUBLE &&
                                 !(fits_double(column.largest) &&
                                   fits_double(std::uint64_t(0) - std::uint64_t(column.smallest))));
}

} // namespace point_files
