// SPDX-License-Identifier: GPL-3.0-or-later
#include "Records.h"

#include "Laz_records.h"

#include <algorithm>

namespace point_files::las {

namespace {

constexpr std::size_t chunk_size = std::size_t(1) << 20;

class Plain_reader : public Record_reader {
  const Input& m_input;
  std::uint64_t m_at, m_end; // of what is not yet in the chunk
  std::size_t m_record_size, m_done = 0;
  std::string m_chunk;

public:
  Plain_reader(const Input& input, const Header& header)
      : m_input(input), m_at(header.points_begin), m_end(header.points_end),
        m_record_size(header.record_size)
  {}

  char* next() override
  {
    if (m_done == m_chunk.size()) {
      const std::size_t whole = (chunk_size / m_record_size + 1) * m_record_size;
      m_chunk.resize(std::size_t((std::min)(std::uint64_t(whole), m_end - m_at)));
      m_input.read(m_at, m_chunk.data(), m_chunk.size());
      m_at += m_chunk.size();
      m_done = 0;
    }
    m_done += m_record_size;
    return m_chunk.data() + m_done - m_record_size;
  }
};

class Plain_writer : public Record_writer {
  std::ostream& m_out;
  std::size_t m_record_size;
  std::string m_chunk;

public:
  Plain_writer(std::ostream& out, std::size_t record_size) : m_out(out), m_record_size(record_size)
  {}

  void write(const char* record) override
  {
    m_chunk.append(record, m_record_size);
    if (m_chunk.size() > chunk_size)
      finish();
  }

  void finish() override
  {
    m_out.write(m_chunk.data(), std::streamsize(m_chunk.size()));
    m_chunk.clear();
  }
};

} // namespace

std::unique_ptr<Record_reader> make_reader(const Input& input, const Header& header)
{
  if (header.is_compressed)
    return make_laz_reader(input, header);
  return std::make_unique<Plain_reader>(input, header);
}

std::unique_ptr<Record_writer> make_writer(std::ostream& out, bool is_compressed,
                                           unsigned point_format, std::size_t record_size)
{
  if (is_compressed)
    return make_laz_writer(out, point_format, record_size);
  return std::make_unique<Plain_writer>(out, record_size);
}

} // namespace point_files::las
