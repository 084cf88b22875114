// SPDX-License-Identifier: GPL-3.0-or-later
#include "Block_writer.h"

#include "Record_stream.h"
#include "Splits.h"
#include "memory_use.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace balanced_flow_blocks {

namespace {

constexpr std::size_t largest_page = 4096;

} // namespace

Block_writer::Block_writer(Manifest& manifest, std::uint64_t total, const Progress& progress)
    : m_manifest(manifest), m_progress(progress),
      m_capacity(points_to_sort(manifest.memory, manifest.has_normals)),
      m_block_size(manifest.block_size), m_total(total)
{}

void Block_writer::sort(const std::filesystem::path& file)
{
  const std::uint64_t count =
      std::filesystem::file_size(file) / Records::bytes_of(m_manifest.has_normals);
  if (count > m_capacity)
    distribute(file, count);
  else
    sort_in_memory(file);
}

/// Distributes the points of a file to files that fit into memory, and sorts these.
void Block_writer::distribute(const std::filesystem::path& file, std::uint64_t count)
{
  const std::uint64_t stride = count / (std::size_t(1) << 18) + 1;
  Records sample(m_manifest.has_normals);
  std::uint64_t next = 0, at = 0;
  for_each_records(file, m_manifest.has_normals, [&](const Records& records) {
    for (; next < at + records.size(); next += stride)
      sample.append(records, std::size_t(next - at));
    at += records.size();
    m_progress(double(m_done) / double(m_total));
  });
  // three quarters: a sample tells the numbers approximately only
  const std::uint64_t most = m_capacity / stride * 3 / 4;
  const Splits splits(sample, std::size_t((std::max)(most, std::uint64_t(1))));
  if (splits.number_of_parts() == 1)
    return sort_in_memory(file); // all in one place

  std::vector<std::filesystem::path> files;
  std::vector<std::unique_ptr<Record_writer>> parts;
  for (std::size_t i = 0; i < splits.number_of_parts(); ++i) {
    files.push_back(m_manifest.directory / ("unsorted." + std::to_string(m_file_count++)));
    parts.push_back(
        std::make_unique<Record_writer>(files.back(), m_manifest.has_normals, std::size_t(2048)));
  }
  for_each_records(file, m_manifest.has_normals, [&](const Records& records) {
    for (std::size_t i = 0; i < records.size(); ++i)
      parts[splits.part_of(records, i)]->append(records, i);
    m_progress(double(m_done) / double(m_total));
  });
  for (const auto& part : parts)
    part->flush();
  parts.clear();
  std::filesystem::remove(file);
  for (const std::filesystem::path& part : files)
    sort(part);
}

void Block_writer::sort_in_memory(const std::filesystem::path& file)
{
  Records records(m_manifest.has_normals);
  {
    const Disk_file in(file, Disk_file::READ);
    const std::uint64_t count = in.size() / records.record_size();
    if (count > (std::numeric_limits<std::uint32_t>::max)())
      throw std::runtime_error("more than 2^32 points are in one place");
    records.resize(std::size_t(count));
    in.read(0, records.bytes(), records.byte_count());
  }
  std::vector<std::uint32_t> order(records.size());
  std::iota(order.begin(), order.end(), 0u);
  if (!order.empty())
    cut_blocks(records, order.data(), order.data() + order.size());
  std::filesystem::remove(file);
}

void Block_writer::cut_blocks(const Records& records, std::uint32_t* first, std::uint32_t* last)
{
  if (std::size_t(last - first) > m_block_size) {
    std::uint32_t* const middle = halve(records, first, last);
    cut_blocks(records, first, middle);
    cut_blocks(records, middle, last);
    return;
  }
  Disk_file file(m_manifest.points_file(m_manifest.blocks.size()), Disk_file::WRITE);
  m_manifest.blocks.push_back(
      {std::uint64_t(last - first), std::uint32_t(m_manifest.pages.size()), std::uint32_t(0)});
  cut_pages(records, first, last, file);
  file.synchronize();
}

void Block_writer::cut_pages(const Records& records, std::uint32_t* first, std::uint32_t* last,
                             Disk_file& file)
{
  if (std::size_t(last - first) <= (std::min)(largest_page, m_block_size / 4 + 1))
    return write_page(records, first, last, file);
  std::uint32_t* const middle = halve(records, first, last);
  cut_pages(records, first, middle, file);
  cut_pages(records, middle, last, file);
}

/// \return where the second half begins
std::uint32_t* Block_writer::halve(const Records& records, std::uint32_t* first,
                                   std::uint32_t* last)
{
  const auto split = split_in_two(records, first, last);
  return split ? first + split->second : first + (last - first) / 2; // all are in one place
}

void Block_writer::write_page(const Records& records, const std::uint32_t* first,
                              const std::uint32_t* last, Disk_file& file)
{
  Page page;
  Block& block = m_manifest.blocks.back();
  page.block = std::uint32_t(m_manifest.blocks.size() - 1);
  page.count = std::uint32_t(last - first);
  if (block.page_count != 0)
    page.first = m_manifest.pages.back().first + m_manifest.pages.back().count;
  Records sorted(m_manifest.has_normals);
  sorted.reserve(page.count);
  for (; first != last; ++first) {
    sorted.append(records, *first);
    page.box.add({records.value(*first, 0), records.value(*first, 1), records.value(*first, 2)});
  }
  page.checksum = Checksum::of(sorted.bytes(), sorted.byte_count());
  file.append(sorted.bytes(), sorted.byte_count());
  m_manifest.pages.push_back(page);
  ++block.page_count;
  m_done += page.count;
  m_progress(double(m_done) / double(m_total));
}

} // namespace balanced_flow_blocks
