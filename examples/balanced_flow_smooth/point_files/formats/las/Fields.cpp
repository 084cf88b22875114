// SPDX-License-Identifier: GPL-3.0-or-later
#include "Fields.h"

#include "Bytes.h"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace point_files::las {

namespace {

constexpr std::size_t descriptor_size = 192;

/// Calls a function with a number of the given type.
template <typename Function>
auto with_number_of(Extra_type type, const Function& f)
{
  switch (type) {
  case Extra_type::UINT8:
    return f(std::uint8_t());
  case Extra_type::INT8:
    return f(std::int8_t());
  case Extra_type::UINT16:
    return f(std::uint16_t());
  case Extra_type::INT16:
    return f(std::int16_t());
  case Extra_type::UINT32:
    return f(std::uint32_t());
  case Extra_type::INT32:
    return f(std::int32_t());
  case Extra_type::UINT64:
    return f(std::uint64_t());
  case Extra_type::INT64:
    return f(std::int64_t());
  case Extra_type::FLOAT:
    return f(float());
  default:
    return f(double());
  }
}

bool is_large_integer(const Field& field)
{
  return field.type == Extra_type::UINT64 || field.type == Extra_type::INT64;
}

} // namespace

std::size_t size_of(Extra_type type)
{
  return with_number_of(type, [](auto number) { return sizeof number; });
}

Extra_type type_of(Scalar scalar)
{
  constexpr Extra_type types[] = {Extra_type::INT8,   Extra_type::UINT8, Extra_type::INT16,
                                  Extra_type::UINT16, Extra_type::INT32, Extra_type::UINT32,
                                  Extra_type::FLOAT,  Extra_type::DOUBLE};
  return types[std::size_t(scalar)];
}

double Field::get(const char* record) const
{
  return with_number_of(type, [&](auto number) {
    number = las::get<decltype(number)>(record + at);
    if (bits != 0)
      return double(unsigned(number) >> shift & ((1u << bits) - 1));
    return double(number) * scale + offset;
  });
}

void Field::put(char* record, double number) const
{
  with_number_of(type, [&](auto typed) {
    typedef decltype(typed) Number;
    typed = static_cast<Number>(number);
    if (bits != 0) // these are bytes
      typed = static_cast<Number>(unsigned(las::get<std::uint8_t>(record + at)) | unsigned(number)
                                                                                      << shift);
    las::put(record + at, typed);
  });
}

bool Field::holds(double number) const
{
  if (type == Extra_type::DOUBLE)
    return true;
  const double smallest = with_number_of(
      type, [](auto t) { return double((std::numeric_limits<decltype(t)>::lowest)()); });
  const double largest = bits != 0 ? double((1u << bits) - 1) : with_number_of(type, [](auto t) {
    return double((std::numeric_limits<decltype(t)>::max)());
  });
  if (!(number >= smallest && number <= largest))
    return false;
  return type == Extra_type::FLOAT ? double(float(number)) == number : std::floor(number) == number;
}

Scalar Field::scalar() const
{
  constexpr Scalar scalars[] = {Scalar::UINT8,  Scalar::INT8,  Scalar::UINT16, Scalar::INT16,
                                Scalar::UINT32, Scalar::INT32, Scalar::DOUBLE, Scalar::DOUBLE,
                                Scalar::FLOAT,  Scalar::DOUBLE};
  return scale != 1. || offset != 0. ? Scalar::DOUBLE : scalars[std::size_t(type) - 1];
}

std::vector<Field> fields_of(unsigned format)
{
  std::vector<Field> fields = {{"Intensity", Extra_type::UINT16, 12}};
  const auto add = [&](const char* name, Extra_type type, std::size_t at, unsigned shift = 0,
                       unsigned bits = 0) {
    fields.push_back({name, type, at, shift, bits});
  };
  constexpr Extra_type byte = Extra_type::UINT8;
  const bool is_new = format >= 6;
  const unsigned width = is_new ? 4 : 3;
  add("ReturnNumber", byte, 14, 0, width);
  add("NumberOfReturns", byte, 14, width, width);
  const std::size_t direction = is_new ? 15 : 14, flags = is_new ? 0 : 5;
  add("ScanDirectionFlag", byte, direction, 6, 1);
  add("EdgeOfFlightLine", byte, direction, 7, 1);
  if (is_new)
    add("Classification", byte, 16);
  else
    add("Classification", byte, 15, 0, 5);
  const char* const names[] = {"Synthetic", "KeyPoint", "Withheld", "Overlap"};
  for (unsigned i = 0; i < width; ++i)
    add(names[i], byte, 15, unsigned(flags) + i, 1);
  if (is_new)
    add("ScannerChannel", byte, 15, 4, 2);
  add("UserData", byte, 17);
  if (is_new)
    add("ScanAngle", Extra_type::INT16, 18);
  else
    add("ScanAngleRank", Extra_type::INT8, 16);
  add("PointSourceId", Extra_type::UINT16, is_new ? 20 : 18);
  std::size_t at = is_new ? 22 : 20;
  if (is_new || (format != 0 && format != 2 && format <= 5)) {
    add("GpsTime", Extra_type::DOUBLE, at);
    at += 8;
  }
  const bool has_infrared = format == 8 || format == 10;
  if (format == 2 || format == 3 || format == 5 || format == 7 || has_infrared)
    for (const char* color : {"Red", "Green", "Blue"}) {
      add(color, Extra_type::UINT16, at);
      at += 2;
    }
  if (has_infrared)
    add("Infrared", Extra_type::UINT16, at);
  return fields;
}

std::string unique_name(std::string name, const std::vector<Field>& others)
{
  for (char& c : name)
    if (!std::isgraph(static_cast<unsigned char>(c)))
      c = '_';
  if (name.empty())
    name = "ExtraBytes";
  const auto is_taken = [&](const std::string& wanted) {
    for (const char* reserved : {"x", "y", "z", "nx", "ny", "nz"})
      if (wanted == reserved)
        return true;
    return std::any_of(others.begin(), others.end(),
                       [&](const Field& other) { return other.name == wanted; });
  };
  std::string unique = name;
  for (int i = 2; is_taken(unique); ++i)
    unique = name + "_" + std::to_string(i);
  return unique;
}

Fields::Fields(const Input& input, const Header& header)
    : m_fields(fields_of(header.point_format)), m_described(smallest_record(header.point_format))
{
  const Variable_record* const description = header.find("LASF_Spec", 4);
  if (!description)
    return;
  std::uint64_t at = description->data;
  for (; at + descriptor_size <= description->end && m_described < header.record_size;
       at += descriptor_size)
    add_extra(input.read(at, descriptor_size).data());
  while (m_fields.back().at + size_of(m_fields.back().type) > header.record_size)
    m_fields.pop_back(); // descriptions of what is not there
}

void Fields::add_extra(const char* descriptor)
{
  const unsigned number = las::get<std::uint8_t>(descriptor + 2);
  const unsigned options = las::get<std::uint8_t>(descriptor + 3);
  if (number == 0 || number > 30) { // bytes without a meaning
    m_described += options;
    return;
  }
  const std::string name = get_text(descriptor + 4, 32);
  Field field;
  field.type = Extra_type((number - 1) % 10 + 1);
  const unsigned elements = (number - 1) / 10 + 1; // 2 and 3 in older files
  for (unsigned i = 0; i < elements; ++i) {
    if ((options & 8) != 0)
      field.scale = las::get<double>(descriptor + 112 + 8 * i);
    if ((options & 16) != 0)
      field.offset = las::get<double>(descriptor + 136 + 8 * i);
    field.name = unique_name(elements == 1 ? name : name + "_" + std::to_string(i), m_fields);
    field.at = m_described;
    m_described += size_of(field.type);
    m_fields.push_back(field);
  }
}

std::vector<std::string> Fields::losses(const Header& header) const
{
  std::vector<std::string> losses = {"the header with its projection"};
  const unsigned format = header.point_format;
  if (format == 4 || format == 5 || format >= 9)
    losses.push_back("the waveforms");
  if (m_described < header.record_size)
    losses.push_back("the " + std::to_string(header.record_size - m_described) +
                     " extra bytes of each point that are not described");
  for (const Field& field : m_fields)
    if (is_large_integer(field))
      losses.push_back("more than 53 bits of " + field.name);
  return losses;
}

} // namespace point_files::las
