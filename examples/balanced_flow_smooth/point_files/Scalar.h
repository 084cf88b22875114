// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_FILES_SCALAR_H
#define POINT_FILES_SCALAR_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>

namespace point_files {

/// The types of numbers in files
enum class Scalar { INT8, UINT8, INT16, UINT16, INT32, UINT32, FLOAT, DOUBLE, INT64, UINT64 };

/// A value of any of these types, with all of its digits
typedef std::variant<double, std::int64_t, std::uint64_t> Number;

/// The name in PLY
const char* name_of(Scalar type);
/// The type of that name in PLY, of which there are two for most; `bool` is one of a byte
std::optional<Scalar> find_scalar(const std::string& name);

inline bool is_integer(Scalar type) { return type != Scalar::FLOAT && type != Scalar::DOUBLE; }

inline bool is_unsigned(Scalar type)
{
  return type == Scalar::UINT8 || type == Scalar::UINT16 || type == Scalar::UINT32 ||
         type == Scalar::UINT64;
}

/// The number of an integer type that is the closest
double round_to(Scalar type, double number);

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
  case Scalar::INT64:
    return f(std::int64_t());
  case Scalar::UINT64:
    return f(std::uint64_t());
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
inline Number number_from_bytes(Scalar type, const char* bytes, bool swapped)
{
  return with_number_of(type, [&](auto number) -> Number {
    char copy[sizeof number];
    std::copy(bytes, bytes + sizeof number, copy);
    if (swapped)
      std::reverse(copy, copy + sizeof number);
    std::memcpy(&number, copy, sizeof number);
    if constexpr (std::is_floating_point<decltype(number)>::value)
      return double(number);
    else if constexpr (std::is_signed<decltype(number)>::value)
      return std::int64_t(number);
    else
      return std::uint64_t(number);
  });
}

inline double to_double(const Number& number)
{
  return std::visit([](auto value) { return double(value); }, number);
}

/// The same as a `double`, which holds all values of all types but those of 64 bits
inline double from_bytes(Scalar type, const char* bytes, bool swapped)
{
  return to_double(number_from_bytes(type, bytes, swapped));
}

/// Throws `std::runtime_error` if an integer type has not that number; what is too large for a `float`
/// becomes the largest one.
void append_bytes(std::string& out, Scalar type, const Number& number, bool swapped);

/// Appends the shortest text that reads back as the same number of this type; integers have no
/// exponent.
void append_text(std::string& out, Scalar type, const Number& number);

/// Reads a number that fills the text from `begin` to `end`.
std::optional<double> from_text(const char* begin, const char* end);

/// The same with all digits, if it is an integer of 64 bits
std::optional<Number> number_from_text(const char* begin, const char* end);

} // namespace point_files

#endif // POINT_FILES_SCALAR_H
