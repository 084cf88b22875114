// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_BLOCKS_RECORD_STREAM_H
#define BALANCED_FLOW_BLOCKS_RECORD_STREAM_H

#include "Disk_file.h"
#include "Page.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>

namespace balanced_flow_blocks {

/// Takes records to a file, a buffer full at a time.
class Record_writer {
  Disk_file m_file;
  Records m_buffer;
  std::size_t m_capacity;

public:
  Record_writer(const std::filesystem::path& path, bool has_normals,
                std::size_t capacity = std::size_t(1) << 14)
      : m_file(path, Disk_file::WRITE), m_buffer(has_normals), m_capacity(capacity)
  {}

  void append(const Records& records, std::size_t i)
  {
    m_buffer.append(records, i);
    if (m_buffer.size() >= m_capacity)
      flush();
  }
  void flush()
  {
    m_file.append(m_buffer.bytes(), m_buffer.byte_count());
    m_buffer.resize(0);
  }
};

/// Calls `visit(records)` for all records of a file, a buffer full at a time.
template <typename Visit>
void for_each_records(const std::filesystem::path& path, bool has_normals, const Visit& visit)
{
  const Disk_file file(path, Disk_file::READ);
  const std::uint64_t count = file.size() / Records::bytes_of(has_normals);
  Records records(has_normals);
  for (std::uint64_t i = 0; i < count; i += records.size()) {
    records.resize(std::size_t((std::min)(count - i, std::uint64_t(1) << 16)));
    file.read(i * records.record_size(), records.bytes(), records.byte_count());
    visit(records);
  }
}

} // namespace balanced_flow_blocks

#endif // BALANCED_FLOW_BLOCKS_RECORD_STREAM_H
