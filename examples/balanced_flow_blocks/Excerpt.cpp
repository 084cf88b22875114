// SPDX-License-Identifier: GPL-3.0-or-later
#include "Excerpt.h"

#include "Disk_file.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

namespace balanced_flow_blocks {

std::uint64_t Excerpt::number_of_required_points() const
{
  std::uint64_t count = 0;
  for (const std::size_t page : m_required)
    count += m_manifest.pages[page].count;
  return count;
}

void Excerpt::read_required()
{
  std::sort(m_required.begin(), m_required.end());
  for (const std::size_t page : m_required)
    if (!m_tree.is_read(page))
      read(page);
  m_required.clear();
}

void Excerpt::read(std::size_t number)
{
  const Page& page = m_manifest.pages[number];
  const std::filesystem::path path = m_manifest.points_file(page.block);
  const Disk_file file(path, Disk_file::READ);
  m_records.resize(page.count);
  file.read(page.first * m_records.record_size(), m_records.bytes(), m_records.byte_count());
  if (Checksum::of(m_records.bytes(), m_records.byte_count()) != page.checksum)
    throw std::runtime_error(path.string() + " is damaged: plan again, in a new directory");
  for (std::size_t i = 0; i < m_records.size(); ++i) {
    points.emplace_back(m_records.value(i, 0), m_records.value(i, 1), m_records.value(i, 2));
    if (m_manifest.has_normals)
      normals.emplace_back(m_records.value(i, 3), m_records.value(i, 4), m_records.value(i, 5));
    numbers.push_back(m_records.number(i));
    if (!m_manifest.scans.empty())
      scans.push_back(m_manifest.scan_of(numbers.back()));
  }
  m_tree.set_read(number);
}

} // namespace balanced_flow_blocks
