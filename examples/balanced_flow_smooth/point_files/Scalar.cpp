// SPDX-License-Identifier: GPL-3.0-or-later
#include "Scalar.h"

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <type_traits>

namespace point_files {

namespace {

constexpr const char* scalar_names[] = {"char", "uchar", "short", "ushort",
                                        "int",  "uint",  "float", "double"};
constexpr const char* other_scalar_names[] = {"int8",  "uint8",  "int16",   "uint16",
                                              "int32", "uint32", "float32", "float64"};

/// The number as one of the type `T`; throws if there is none, except that what is too large for a
/// `float` becomes the largest one.
template <typename T>
T narrow(double number)
{
  if constexpr (std::is_same<T, float>::value) {
    const double largest = (std::numeric_limits<float>::max)();
    return std::isnan(number) ? (std::numeric_limits<float>::quiet_NaN)()
                              : float((std::min)((std::max)(number, -largest), largest));
  }
  else if constexpr (std::is_integral<T>::value) {
    if (!(number >= double((std::numeric_limits<T>::min)()) &&
          number <= double((std::numeric_limits<T>::max)()) && std::floor(number) == number))
      throw std::runtime_error(std::to_string(number) + " does not fit the type of its property");
  }
  return static_cast<T>(number);
}

} // namespace

const char* name_of(Scalar type) { return scalar_names[std::size_t(type)]; }

std::optional<Scalar> find_scalar(const std::string& name)
{
  for (std::size_t i = 0; i < 8; ++i)
    if (name == scalar_names[i] || name == other_scalar_names[i])
      return Scalar(i);
  return std::nullopt;
}

void append_bytes(std::string& out, Scalar type, double number, bool swapped)
{
  with_number_of(type, [&](auto typed) {
    typed = narrow<decltype(typed)>(number);
    char bytes[sizeof typed];
    std::memcpy(bytes, &typed, sizeof typed);
    if (swapped)
      std::reverse(bytes, bytes + sizeof typed);
    out.append(bytes, sizeof typed);
  });
}

void append_text(std::string& out, Scalar type, double number)
{
  with_number_of(type, [&](auto typed) {
    char text[64];
    // to_chars writes characters as letters: promote
    const auto end = std::to_chars(text, text + sizeof text, +narrow<decltype(typed)>(number)).ptr;
    out.append(text, end);
  });
}

std::optional<double> from_text(const char* begin, const char* end)
{
  if (begin != end && *begin == '+')
    ++begin;
  double number = 0.;
  const auto parsed = std::from_chars(begin, end, number);
  if (parsed.ptr == begin || parsed.ptr != end)
    return std::nullopt;
  if (parsed.ec == std::errc::result_out_of_range) // 1e-400 is 0 and no error
    number = std::strtod(std::string(begin, end).c_str(), nullptr);
  return number;
}

} // namespace point_files
