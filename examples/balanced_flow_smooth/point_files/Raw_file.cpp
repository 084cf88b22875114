// SPDX-License-Identifier: GPL-3.0-or-later
#include "Raw_file.h"

#include <algorithm>
#include <cstdint>

namespace point_files {

bool is_little_endian()
{
  const std::uint16_t one = 1;
  return reinterpret_cast<const char&>(one) == 1;
}

Raw_file::Raw_file(Anatomy file) : m_file(std::move(file))
{
  std::size_t count = 0;
  for (Block& block : m_file.blocks) {
    block.first.bytes = &m_file.bytes;
    count += block.count;
  }
  for (std::size_t c = 0; c < 3; ++c) {
    m_changing.emplace_back(m_file.layout.coordinates()[c], c);
    if (m_file.layout.has_normals())
      m_changing.emplace_back(m_file.layout.normals()[c], c + 3);
  }
  std::sort(m_changing.begin(), m_changing.end());
  warnings = m_file.warnings;
  defines_invalid = m_file.defines_invalid;
  zeros_are_invalid = m_file.zeros_are_invalid;
  load(count, m_file.layout.has_normals());
  find_sides();
  number_scans();
  roles = m_file.layout.roles();
  roles_source = m_file.layout_source;
  for (const std::size_t p : m_file.layout.coordinates())
    if (is_integer(m_file.layout.properties()[p].type) && warnings.empty())
      warnings.push_back("coordinates are integers: points are rounded to them in this format");
}

/// Makes sides of the places of the scanners.
void Raw_file::find_sides()
{
  std::size_t i = 0;
  for (const Block& block : m_file.blocks) {
    if (block.frame && sides.empty())
      sides.resize(points.size(), CGAL::NULL_VECTOR);
    for (std::size_t k = 0; k < block.count; ++k, ++i)
      if (block.frame && points[i] != Point_3(CGAL::ORIGIN)) {
        const Scan_frame::Triple& p = block.frame->position();
        sides[i] = Point_3(p[0], p[1], p[2]) - points[i];
      }
  }
}

/// Blocks are scans.
void Raw_file::number_scans()
{
  const auto is_empty = [](const Block& block) { return block.count == 0; };
  const std::vector<Block>& blocks = m_file.blocks;
  if (blocks.size() - std::size_t(std::count_if(blocks.begin(), blocks.end(), is_empty)) < 2)
    return;
  std::uint32_t number = 0;
  for (const Block& block : blocks) {
    scans.insert(scans.end(), block.count, number);
    number += is_empty(block) ? 0 : 1;
  }
}

bool Raw_file::has_integer_normals() const
{
  const Layout& layout = m_file.layout;
  return layout.has_normals() && is_integer(layout.properties()[layout.normals()[0]].type);
}

void Raw_file::for_each_record(bool with_values, const Visitor& visit) const
{
  const Layout& layout = m_file.layout;
  const std::vector<Property>& properties = layout.properties();
  const std::vector<std::size_t> others =
      with_values ? layout.others() : std::vector<std::size_t>();
  Record record = {{0., 0., 0.}, {0., 0., 0.}, std::vector<Number>(others.size())};
  for_each_fields([&](const auto& cursor, const std::vector<Field>& fields, std::size_t,
                      const Block& block, std::size_t) {
    const auto value = [&](std::size_t p) { return cursor.value(fields[p], properties[p].type); };
    const Scan_frame::Triple p = coordinates(cursor, fields);
    const Scan_frame::Triple shared = block.frame ? block.frame->to_shared(p) : p;
    std::copy(shared.begin(), shared.end(), record.coordinates);
    for (std::size_t c = 0; layout.has_normals() && c < 3; ++c)
      record.normal[c] = value(layout.normals()[c]);
    if (has_integer_normals()) {
      const double length = length_of_normal(cursor, fields);
      for (double& n : record.normal)
        n = length != 0. ? n / length : 0.;
    }
    for (std::size_t c = 0; c < others.size(); ++c)
      record.values[c] = cursor.exact_value(fields[others[c]], properties[others[c]].type);
    visit(record);
  });
}

const Column_types& Raw_file::column_types() const
{
  if (!m_columns) {
    const std::vector<std::size_t> others = m_file.layout.others();
    m_columns.emplace(others.size());
    for_each_fields(
        [&](const auto&, const std::vector<Field>& fields, std::size_t, const Block&, std::size_t) {
          for (std::size_t c = 0; c < others.size(); ++c) {
            const Field& field = fields[others[c]];
            m_columns->add(c, m_file.bytes.substr(field.begin, field.end - field.begin));
          }
        });
  }
  return *m_columns;
}

std::vector<Property> Raw_file::columns() const
{
  std::vector<Property> columns;
  for (const std::size_t i : m_file.layout.others()) {
    Property column = m_file.layout.properties()[i];
    if (!m_file.has_types)
      column.type = column_types().type(columns.size());
    columns.push_back(column);
  }
  return columns;
}

std::vector<std::string> Raw_file::losses() const
{
  std::vector<std::string> losses = m_file.losses;
  const std::vector<Property> all = m_file.has_types ? std::vector<Property>() : columns();
  for (std::size_t c = 0; c < all.size(); ++c)
    if (column_types().loses_digits(c))
      losses.push_back("all digits of " + all[c].name);
  return losses;
}

} // namespace point_files
