// SPDX-License-Identifier: GPL-3.0-or-later
#include "Las_file.h"

#include "las/Bytes.h"
#include "las/Records.h"
#include "las/Rewriting.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
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

void Las_file::write(const Target& target) const
{
  las::Rewriting rewriting(m_input, m_header);
  rewriting.point = [&](std::size_t i) { return points[i]; };
  if (drops_invalid) {
    rewriting.is_dropped = [&](std::size_t i) { return is_dropped(i); };
    rewriting.number_of_dropped = invalid.size();
  }
  rewriting.write(target);
}

} // namespace point_files
