// SPDX-License-Identifier: GPL-3.0-or-later
#include "Fields.h"

#include "../../Raw_file.h"
#include "Bytes.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace point_files::las {

namespace {

constexpr std::size_t descriptor_size = 192;

/// The types of extra bytes; LAS counts from 1 on.
constexpr Scalar types[] = {Scalar::UINT8,  Scalar::INT8,  Scalar::UINT16, Scalar::INT16,
                            Scalar::UINT32, Scalar::INT32, Scalar::UINT64, Scalar::INT64,
                            Scalar::FLOAT,  Scalar::DOUBLE};

} // namespace

unsigned number_of(Scalar type)
{
  return unsigned(std::find(std::begin(types), std::end(types), type) - std::begin(types)) + 1;
}

Number Field::get(const char* record) const
{
  const Number number = number_from_bytes(type, record + at, !is_little_endian());
  if (bits != 0)
    return std::get<std::uint64_t>(number) >> shift & ((1u << bits) - 1);
  if (scale != 1. || offset != 0.)
    return to_double(number) * scale + offset;
  return number;
}

void Field::put(char* record, const Number& number) const
{
  if (bits != 0) { // of a byte
    const auto others = las::get<std::uint8_t>(record + at);
    las::put(record + at, std::uint8_t(others | unsigned(to_double(number)) << shift));
    return;
  }
  std::string bytes;
  append_bytes(bytes, type, number, !is_little_endian());
  std::copy(bytes.begin(), bytes.end(), record + at);
}

bool Field::holds(const Number& number) const
{
  const double value = to_double(number);
  if (type == Scalar::DOUBLE)
    return std::holds_alternative<double>(number) || std::abs(value) < std::ldexp(1., 53);
  const auto [smallest, largest] = with_number_of(type, [](auto t) {
    typedef std::numeric_limits<decltype(t)> Limits;
    return std::make_pair(double((Limits::lowest)()), double((Limits::max)()));
  });
  return std::floor(value) == value && value >= smallest &&
         value <= (bits != 0 ? double((1u << bits) - 1) : largest);
}

Scalar Field::scalar() const { return scale != 1. || offset != 0. ? Scalar::DOUBLE : type; }

std::vector<Field> fields_of(unsigned format)
{
  std::vector<Field> fields = {{"Intensity", Scalar::UINT16, 12}};
  const auto add = [&](const char* name, Scalar type, std::size_t at, unsigned shift = 0,
                       unsigned bits = 0) {
    fields.push_back({name, type, at, shift, bits});
  };
  constexpr Scalar byte = Scalar::UINT8;
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
    add("ScanAngle", Scalar::INT16, 18);
  else
    add("ScanAngleRank", Scalar::INT8, 16);
  add("PointSourceId", Scalar::UINT16, is_new ? 20 : 18);
  std::size_t at = is_new ? 22 : 20;
  if (is_new || (format != 0 && format != 2 && format <= 5)) {
    add("GpsTime", Scalar::DOUBLE, at);
    at += 8;
  }
  const bool has_infrared = format == 8 || format == 10;
  if (format == 2 || format == 3 || format == 5 || format == 7 || has_infrared)
    for (const char* color : {"Red", "Green", "Blue"}) {
      add(color, Scalar::UINT16, at);
      at += 2;
    }
  if (has_infrared)
    add("Infrared", Scalar::UINT16, at);
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
  field.type = types[(number - 1) % 10];
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
  return losses;
}

} // namespace point_files::las
