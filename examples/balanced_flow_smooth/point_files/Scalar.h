// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_SMOOTH_SCALAR_H
#define BALANCED_FLOW_SMOOTH_SCALAR_H

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>

/// The types of numbers in files, and their names in PLY. A `double` holds each value of each.
enum class Scalar { INT8, UINT8, INT16, UINT16, INT32, UINT32, FLOAT, DOUBLE };

constexpr const char* scalar_names[] = {"char", "uchar", "short", "ushort",
                                        "int",  "uint",  "float", "double"};
constexpr const char* other_scalar_names[] = {"int8",  "uint8",  "int16",   "uint16",
                                              "int32", "uint32", "float32", "float64"};

inline const char* name_of(Scalar type) { return scalar_names[std::size_t(type)]; }

inline std::optional<Scalar> find_scalar(const std::string& name)
{
  for (std::size_t i = 0; i < 8; ++i)
    if (name == scalar_names[i] || name == other_scalar_names[i])
      return Scalar(i);
  return std::nullopt;
}

inline bool is_integer(Scalar type) { return type != Scalar::FLOAT && type != Scalar::DOUBLE; }

/// Calls a function with a number of the given type.
template <typename Function>
auto with_number_of(Scalar type, const Function& f)
{
  switch (type) {
  case Scalar::INT8:
    return f(std::int8_t());
  case Scalar::UINT8:
    return f(std::uint8_t());
  case Scalar::INT16:
    return f(std::int16_t());
  case Scalar::UINT16:
    return f(std::uint16_t());
  case Scalar::INT32:
    return f(std::int32_t());
  case Scalar::UINT32:
    return f(std::uint32_t());
  case Scalar::FLOAT:
    return f(float());
  default:
    return f(double());
  }
}

inline std::size_t size_of(Scalar type)
{
  return with_number_of(type, [](auto number) { return sizeof number; });
}

/// \param swapped whether the bytes are in the other order than in memory
inline double from_bytes(Scalar type, const char* bytes, bool swapped)
{
  return with_number_of(type, [&](auto number) {
    char copy[sizeof number];
    std::copy(bytes, bytes + sizeof number, copy);
    if (swapped)
      std::reverse(copy, copy + sizeof number);
    std::memcpy(&number, copy, sizeof number);
    return double(number);
  });
}

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

inline void append_bytes(std::string& out, Scalar type, double number, bool swapped)
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

/// Appends the shortest text that reads back as the same number of this type.
inline void append_text(std::string& out, Scalar type, double number)
{
  with_number_of(type, [&](auto typed) {
    char text[64];
    // to_chars writes characters as letters: promote
    const auto end = std::to_chars(text, text + sizeof text, +narrow<decltype(typed)>(number)).ptr;
    out.append(text, end);
  });
}

/// Reads a number that fills the text from `begin` to `end`.
inline std::optional<double> from_text(const char* begin, const char* end)
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

#endif // BALANCED_FLOW_SMOOTH_SCALAR_H
