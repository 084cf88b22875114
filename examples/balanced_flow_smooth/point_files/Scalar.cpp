// SPDX-License-Identifier: GPL-3.0-or-later
#include "Scalar.h"

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <type_traits>

namespace point_files {

namespace {

constexpr const char* scalar_names[] = {"char", "uchar", "short",  "ushort", "int",
                                        "uint", "float", "double", "int64",  "uint64"};
constexpr const char* other_scalar_names[] = {"int8",   "uint8",   "int16",   "uint16", "int32",
                                              "uint32", "float32", "float64", "int64",  "uint64"};

/// Whether an integer type has the number
template <typename T>
bool has(double number)
{
  typedef std::numeric_limits<T>
      Limits; // the largest value may be none of `double`, but not 1 more
  return number >= double((Limits::min)()) && number < std::ldexp(1., Limits::digits) &&
         std::floor(number) == number;
}

template <typename T>
bool has(std::int64_t number)
{
  typedef std::numeric_limits<T> Limits;
  return number < 0 ? Limits::is_signed && number >= std::int64_t((Limits::min)())
                    : std::uint64_t(number) <= std::uint64_t((Limits::max)());
}

template <typename T>
bool has(std::uint64_t number)
{
  return number <= std::uint64_t((std::numeric_limits<T>::max)());
}

/// The number as one of the type `T`; throws if there is none, except that what is too large for a
/// `float` becomes the largest one.
template <typename T, typename Value>
T narrow(Value number)
{
  if constexpr (std::is_same<T, float>::value) {
    const double largest = (std::numeric_limits<float>::max)();
    const double real = double(number);
    return std::isnan(real) ? (std::numeric_limits<float>::quiet_NaN)()
                            : float((std::min)((std::max)(real, -largest), largest));
  }
  else if constexpr (std::is_integral<T>::value) {
    if (!has<T>(number))
      throw std::runtime_error(std::to_string(number) + " does not fit the type of its property");
  }
  return static_cast<T>(number);
}

template <typename T>
T narrow_number(const Number& number)
{
  return std::visit([](auto value) { return narrow<T>(value); }, number);
}

} // namespace

const char* name_of(Scalar type) { return scalar_names[std::size_t(type)]; }

double round_to(Scalar type, double number)
{
  return with_number_of(type, [&](auto typed) {
    typedef std::numeric_limits<decltype(typed)> Limits;
    return (std::max)(double((Limits::min)()),
                      (std::min)(std::nearbyint(number), double((Limits::max)())));
  });
}

std::optional<Scalar> find_scalar(const std::string& name)
{
  if (name == "bool")
    return Scalar::UINT8;
  for (std::size_t i = 0; i < std::size(scalar_names); ++i)
    if (name == scalar_names[i] || name == other_scalar_names[i])
      return Scalar(i);
  return std::nullopt;
}

void append_bytes(std::string& out, Scalar type, const Number& number, bool swapped)
{
  with_number_of(type, [&](auto typed) {
    typed = narrow_number<decltype(typed)>(number);
    char bytes[sizeof typed];
    std::memcpy(bytes, &typed, sizeof typed);
    if (swapped)
      std::reverse(bytes, bytes + sizeof typed);
    out.append(bytes, sizeof typed);
  });
}

void append_text(std::string& out, Scalar type, const Number& number)
{
  char text[64];
  const auto append = [&](auto... what) {
    out.append(text, std::to_chars(text, text + sizeof text, what...).ptr);
  };
  with_number_of(type, [&](auto typed) {
    typedef decltype(typed) Type;
    if constexpr (std::is_integral<Type>::value)
      append(+narrow_number<Type>(number)); // to_chars writes characters as letters: promote
    else if (!std::holds_alternative<double>(number)) // has digits that a `double` may not have
      std::visit(
          [&](auto value) {
            if constexpr (std::is_integral<decltype(value)>::value)
              append(value);
          },
          number);
    else {
      typed = narrow_number<Type>(number);
      if (std::floor(typed) == typed && std::abs(typed) < Type(1e15))
        append(typed, std::chars_format::fixed); // 100000, not 1e+05
      else
        append(typed);
    }
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

std::optional<Number> number_from_text(const char* begin, const char* end)
{
  const char* digits = begin != end && *begin == '+' ? begin + 1 : begin;
  const auto read = [&](auto number) -> std::optional<Number> {
    const auto parsed = std::from_chars(digits, end, number);
    if (parsed.ec != std::errc() || parsed.ptr != end)
      return std::nullopt;
    return Number(number);
  };
  if (const auto number = read(std::int64_t()))
    return number;
  if (const auto number = read(std::uint64_t()))
    return number;
  if (const auto number = from_text(begin, end))
    return Number(*number);
  return std::nullopt;
}

} // namespace point_files
