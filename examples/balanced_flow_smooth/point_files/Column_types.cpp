// SPDX-License-Identifier: GPL-3.0-or-later
#include "Column_types.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iomanip>
#include <limits>
#include <optional>
#include <sstream>

namespace point_files {

namespace {

/// The digits from the first to the last that is not 0, without the exponent
std::string significant_digits(const std::string& word)
{
  std::string digits;
  for (const char c : word.substr(0, word.find_first_of("eE")))
    if (std::isdigit(static_cast<unsigned char>(c)) && !(digits.empty() && c == '0'))
      digits += c;
  digits.erase(digits.find_last_not_of('0') + 1);
  return digits;
}

/// Whether a word has digits that a `double` would not give back
bool has_more_digits(const std::string& word, double number)
{
  const std::string digits = significant_digits(word);
  if (digits.size() <= std::size_t(std::numeric_limits<double>::digits10))
    return false;
  std::ostringstream again;
  again << std::scientific << std::setprecision(int(digits.size()) - 1) << number;
  return significant_digits(again.str()) != digits;
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
    column.loses_digits =
        column.loses_digits || (std::isfinite(*real) && has_more_digits(word, *real));
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
