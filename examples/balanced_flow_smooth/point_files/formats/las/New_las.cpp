// SPDX-License-Identifier: GPL-3.0-or-later
#include "New_las.h"

#include "../../write_rows.h"
#include "Bytes.h"
#include "Output.h"
#include "fail.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

namespace point_files::las {

namespace {

constexpr std::size_t header_size = 375, descriptor_size = 192, name_size = 32;
constexpr unsigned largest_format = 8; // has all fields that are no waveforms

bool is_same_name(const std::string& a, const std::string& b)
{
  const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [&](char c, char d) { return lower(c) == lower(d); });
}

/// The smallest power of ten that is not below a number
double power_of_ten(double number)
{
  return std::stod("1e" + std::to_string(int(std::ceil(std::log10(number)))));
}

void put_text(std::string& bytes, std::size_t at, const std::string& text)
{
  std::copy(text.begin(), text.end(), bytes.begin() + std::ptrdiff_t(at));
}

} // namespace

New_las::New_las(const Point_file& file) : m_file(file)
{
  choose_grid();
  choose_fields();
  find_bounds();
}

/// The same decimal scale for all coordinates, so fine that a quarter of 32 bits holds all points, but no finer than the
/// coordinates. So points of a flat cloud can move off its plane later.
void New_las::choose_grid()
{
  double middle[3], extent = 0., size = 0.;
  for (int c = 0; c < 3; ++c) {
    double min = (std::numeric_limits<double>::infinity)(), max = -min;
    for (std::size_t i = 0; i < m_file.points.size(); ++i) {
      const double value = m_file.points[i][c];
      if (std::isfinite(value) && !m_file.is_dropped(i)) { // others are refused
        min = (std::min)(min, value);
        max = (std::max)(max, value);
      }
    }
    middle[c] = min + (max - min) / 2.;
    extent = (std::max)(extent, max - min);
    size = (std::max)({size, std::abs(min), std::abs(max)});
    if (!std::isfinite(max - min) || size > 1e300)
      fail("the points are too far from each other for LAS, from ", min, " to ", max, " in ",
           axis_name(std::size_t(c)));
  }
  const double finest = (std::max)(size * std::numeric_limits<double>::epsilon(), 1e-290);
  const double scale = power_of_ten((std::max)(extent / 1e9, finest)), round = scale * 1e6;
  for (std::size_t c = 0; c < 3; ++c) {
    m_grid.scale[c] = scale;
    m_grid.offset[c] = std::round(middle[c] / round) * round;
  }
}

Field New_las::add_extra(const std::string& name, Scalar type)
{
  if (name.size() > name_size)
    fail("the name ", name, " has more than the ", name_size, " characters of LAS");
  Field field;
  field.name = name;
  field.type = type;
  m_extra.push_back(field);
  return field;
}

void New_las::choose_fields()
{
  const std::vector<Field> fields = fields_of(largest_format);
  const std::vector<Property> columns = m_file.columns();
  std::vector<std::size_t> chosen(columns.size(), fields.size());
  for (std::size_t c = 0; c < columns.size(); ++c)
    for (std::size_t f = 0; f < fields.size(); ++f)
      if (is_same_name(columns[c].name, fields[f].name) &&
          std::find(chosen.begin(), chosen.end(), f) == chosen.end())
        chosen[c] = f;
  for_each_record_to_write(m_file, [&](std::size_t, const Record& record) {
    for (std::size_t c = 0; c < columns.size(); ++c)
      if (chosen[c] < fields.size() && !fields[chosen[c]].holds(record.values[c]))
        chosen[c] = fields.size();
  });
  for (std::size_t c = 0; c < columns.size(); ++c) {
    if (chosen[c] == fields.size()) {
      m_columns.push_back(add_extra(columns[c].name, columns[c].type));
      continue;
    }
    const Field& field = fields[chosen[c]];
    m_columns.push_back(field);
    const bool is_color = field.name == "Red" || field.name == "Green" || field.name == "Blue";
    m_point_format = (std::max)(m_point_format, field.name == "Infrared" ? 8u : is_color ? 7u : 6u);
    m_has_returns =
        m_has_returns || field.name == "ReturnNumber" || field.name == "NumberOfReturns";
  }
  for (const char* name : {"NormalX", "NormalY", "NormalZ"})
    if (!m_file.normals.empty())
      m_normals.push_back(add_extra(name, Scalar::DOUBLE));
  m_record_size = smallest_record(m_point_format);
  for (auto* list : {&m_columns, &m_normals})
    for (Field& field : *list)
      if (field.at == 0) {
        field.at = m_record_size;
        m_record_size += size_of(field.type);
      }
  if (m_extra.size() * descriptor_size > (std::numeric_limits<std::uint16_t>::max)())
    fail("there are ", m_extra.size(), " columns, too many for LAS");
}

void New_las::find_bounds()
{
  std::array<std::int32_t, 3> min, max;
  min.fill((std::numeric_limits<std::int32_t>::max)());
  max.fill((std::numeric_limits<std::int32_t>::min)());
  std::string bytes;
  for_each_record_to_write(m_file, [&](std::size_t i, const Record& record) {
    fill(bytes, record, i);
    for (std::size_t c = 0; c < 3; ++c) {
      min[c] = (std::min)(min[c], get<std::int32_t>(&bytes[4 * c]));
      max[c] = (std::max)(max[c], get<std::int32_t>(&bytes[4 * c]));
    }
    const unsigned number = get<std::uint8_t>(&bytes[14]) & 15u; // 0 is none
    if (number != 0)
      ++m_returns[number - 1];
  });
  for (std::size_t c = 0; c < 3; ++c) {
    m_min[c] = m_grid.coordinate(min[c], c);
    m_max[c] = m_grid.coordinate(max[c], c);
  }
}

std::string New_las::header() const
{
  std::string bytes(header_size, '\0');
  put_text(bytes, 0, "LASF");
  put(&bytes[at::global_encoding], std::uint16_t(16)); // as LAS demands of these point formats
  put(&bytes[at::version], std::uint8_t(1));
  put(&bytes[at::version + 1], std::uint8_t(4));
  put_text(bytes, 26, "OTHER"); // than a scanner
  put_text(bytes, 58, "balanced-flow-smooth");
  put(&bytes[at::header_size], std::uint16_t(header_size));
  put(&bytes[at::record_size], std::uint16_t(m_record_size));
  for (std::size_t c = 0; c < 3; ++c) {
    put(&bytes[at::scale + 8 * c], m_grid.scale[c]);
    put(&bytes[at::offset + 8 * c], m_grid.offset[c]);
    put(&bytes[at::bounds + 16 * c], m_max[c]);
    put(&bytes[at::bounds + 16 * c + 8], m_min[c]);
  }
  put(&bytes[at::count], std::uint64_t(m_file.number_of_points_to_write()));
  for (std::size_t r = 0; r < m_returns.size(); ++r)
    put(&bytes[at::counts_by_return + 8 * r], m_returns[r]);
  return bytes;
}

/// The variable length record that describes the extra bytes
std::string New_las::extra_bytes_record() const
{
  std::string bytes(54 + m_extra.size() * descriptor_size, '\0');
  put_text(bytes, 2, "LASF_Spec");
  put(&bytes[18], std::uint16_t(4));
  put(&bytes[20], std::uint16_t(m_extra.size() * descriptor_size));
  for (std::size_t e = 0; e < m_extra.size(); ++e) {
    put(&bytes[54 + e * descriptor_size + 2], std::uint8_t(number_of(m_extra[e].type)));
    put_text(bytes, 54 + e * descriptor_size + 4, m_extra[e].name);
  }
  return bytes;
}

void New_las::fill(std::string& bytes, const Record& record, std::size_t i) const
{
  bytes.assign(m_record_size, '\0');
  for (std::size_t c = 0; c < 3; ++c)
    put(&bytes[4 * c], m_grid.integer(m_file.points[i][int(c)], c, i));
  if (!m_has_returns)
    put(&bytes[14], std::uint8_t(0x11)); // the first of one
  for (std::size_t c = 0; c < m_columns.size(); ++c)
    m_columns[c].put(bytes.data(), record.values[c]);
  for (std::size_t c = 0; c < m_normals.size(); ++c)
    m_normals[c].put(bytes.data(), m_file.normals[i][int(c)]);
}

void New_las::write(const Target& target) const
{
  Frame frame;
  frame.header = header();
  frame.point_format = m_point_format;
  frame.record_size = m_record_size;
  frame.count = m_file.number_of_points_to_write();
  if (!m_extra.empty()) {
    frame.new_vlrs = extra_bytes_record();
    frame.vlr_count = 1;
  }
  write_file(target, frame, [&](Record_writer& writer) {
    std::string bytes;
    for_each_record_to_write(m_file, [&](std::size_t i, const Record& record) {
      fill(bytes, record, i);
      writer.write(bytes.data());
    });
  });
}

} // namespace point_files::las
