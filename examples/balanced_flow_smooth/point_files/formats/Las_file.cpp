// SPDX-License-Identifier: GPL-3.0-or-later
#include "Las_file.h"

#include "las/Bytes.h"
#include "las/Output.h"
#include "las/Records.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <tuple>
#include <utility>

namespace point_files {

Las_file::Las_file(las::Input input)
    : m_input(std::move(input)), m_header(m_input), m_fields(m_input, m_header)
{
  format = find_format(m_header.is_compressed ? "laz" : "las"); // whatever its name
  // a number of compressed points can lie: memory comes as the file gives reasons for it
  load(std::size_t((std::min)(m_header.count, m_input.size())), false);
  if (m_header.is_copc())
    warnings.push_back("this is COPC: it is written as LAZ without the records of COPC, unless no "
                       "point changes");
  for (const las::Field& field : m_fields.all())
    if (role_of(field.name) == "nx")
      warnings.push_back("the normals in its extra bytes stay as they are");
}

void Las_file::for_each_record(bool with_values, const Visitor& visit) const
{
  const std::size_t width = with_values ? m_fields.all().size() : 0;
  Record record = {{0., 0., 0.}, {0., 0., 0.}, std::vector<Number>(width)};
  const auto reader = las::make_reader(m_input, m_header);
  for (std::uint64_t i = 0; i < m_header.count; ++i) {
    const char* const bytes = reader->next();
    for (std::size_t c = 0; c < 3; ++c)
      record.coordinates[c] = m_header.grid.coordinate(las::get<std::int32_t>(bytes + 4 * c), c);
    for (std::size_t c = 0; c < width; ++c)
      record.values[c] = m_fields.all()[c].get(bytes);
    visit(record);
  }
}

std::vector<Property> Las_file::columns() const
{
  std::vector<Property> columns;
  for (const las::Field& field : m_fields.all())
    columns.emplace_back(field.name, field.scalar());
  return columns;
}

/// The coordinates of a point for its record; a coordinate that is the same stays the same.
std::array<std::int32_t, 3> Las_file::new_integers(const char* record, std::size_t i) const
{
  std::array<std::int32_t, 3> integers;
  for (std::size_t c = 0; c < 3; ++c) {
    integers[c] = las::get<std::int32_t>(record + 4 * c);
    if (points[i][int(c)] != m_header.grid.coordinate(integers[c], c))
      integers[c] = m_header.grid.integer(points[i][int(c)], c, i);
  }
  return integers;
}

/// Finds out, before anything is written, whether all points can be written.
Las_file::Change Las_file::find_change() const
{
  std::array<std::int32_t, 3> min, max;
  min.fill((std::numeric_limits<std::int32_t>::max)());
  max.fill((std::numeric_limits<std::int32_t>::min)());
  Change change = {};
  const auto reader = las::make_reader(m_input, m_header);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const char* const record = reader->next();
    if (is_dropped(i)) {
      const unsigned bits = m_header.point_format < 6 ? 7 : 15;
      const unsigned number =
          las::get<std::uint8_t>(record + 14) & bits; // of the return, from 1 on
      if (number != 0)
        ++change.dropped_returns[number - 1];
      change.any = true;
      continue;
    }
    const auto integers = new_integers(record, i);
    for (std::size_t c = 0; c < 3; ++c) {
      change.any = change.any || integers[c] != las::get<std::int32_t>(record + 4 * c);
      min[c] = (std::min)(min[c], integers[c]);
      max[c] = (std::max)(max[c], integers[c]);
    }
  }
  for (std::size_t c = 0; c < 3; ++c)
    std::tie(change.min[c], change.max[c]) =
        std::minmax({m_header.grid.coordinate(min[c], c), m_header.grid.coordinate(max[c], c)});
  return change;
}

/// Sets the bounds, and the counts if points are dropped.
void Las_file::announce(const Change& change, std::string& header) const
{
  for (std::size_t c = 0; c < 3; ++c) {
    las::put(&header[las::at::bounds + 16 * c], change.max[c]);
    las::put(&header[las::at::bounds + 16 * c + 8], change.min[c]);
  }
  if (!drops_invalid)
    return;
  const auto subtract = [&](auto number, std::size_t place, std::uint64_t dropped) {
    typedef decltype(number) Count;
    const auto before = las::get<Count>(&header[place]); // 0 if the header does not tell it
    las::put(&header[place], Count(before - (std::min)(std::uint64_t(before), dropped)));
  };
  subtract(std::uint32_t(), las::at::legacy_count, invalid.size());
  for (std::size_t r = 0; r < 5; ++r)
    subtract(std::uint32_t(), las::at::legacy_counts_by_return + 4 * r, change.dropped_returns[r]);
  if (m_header.minor_version < 4)
    return;
  subtract(std::uint64_t(), las::at::count, invalid.size());
  for (std::size_t r = 0; r < 15; ++r)
    subtract(std::uint64_t(), las::at::counts_by_return + 8 * r, change.dropped_returns[r]);
}

void Las_file::write(const Target& target) const
{
  m_input.check_unchanged();
  const Change change = find_change();
  const bool is_laz = target.format.name == "laz";
  if (!change.any && is_laz == m_header.is_compressed)
    m_input.copy(0, m_input.size(), target.out);
  else {
    las::Frame frame(m_input, m_header, is_laz || m_header.is_compressed);
    frame.count = number_of_points_to_write();
    if (change.any)
      announce(change, frame.header);
    las::write_file(target, frame, [&](las::Record_writer& writer) {
      const auto reader = las::make_reader(m_input, m_header);
      for (std::size_t i = 0; i < points.size(); ++i) {
        char* const record = reader->next();
        if (is_dropped(i))
          continue;
        const auto integers = new_integers(record, i);
        for (std::size_t c = 0; c < 3; ++c)
          las::put(record + 4 * c, integers[c]);
        writer.write(record);
      }
    });
  }
  m_input.check_unchanged();
}

} // namespace point_files
