// SPDX-License-Identifier: GPL-3.0-or-later
#include "Compressed_file.h"

#include "lzf.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace point_files::pcd {

namespace {

/// From records to fields one after the other, or back
std::string transpose(const std::string& points, const Header& header, bool to_fields)
{
  std::string transposed(points.size(), '\0');
  const std::size_t record_size = header.record_size();
  std::size_t before = 0; // this field in a record
  for (const Value_field& field : header.fields) {
    for (std::size_t i = 0; i < header.count; ++i) {
      const std::size_t in_record = i * record_size + before;
      const std::size_t in_fields = before * header.count + i * field.width();
      std::copy_n(points.begin() + std::ptrdiff_t(to_fields ? in_record : in_fields), field.width(),
                  transposed.begin() + std::ptrdiff_t(to_fields ? in_fields : in_record));
    }
    before += field.width();
  }
  return transposed;
}

constexpr std::size_t size_of_sizes = 8;

/// One of the two sizes that are before compressed points
std::size_t get_size(const Bytes& bytes, std::size_t at)
{
  return std::size_t(from_bytes(Scalar::UINT32, bytes.data() + at, !is_little_endian()));
}

void append_size(std::string& bytes, std::size_t size)
{
  append_bytes(bytes, Scalar::UINT32, Number(std::uint64_t(size)), !is_little_endian());
}

bool has_size(const Header& header, std::size_t size)
{
  const std::size_t record_size = header.record_size();
  return record_size != 0 && size % record_size == 0 && size / record_size == header.count;
}

} // namespace

std::string decompress(const Bytes& bytes, Header& header)
{
  const std::size_t begin = header.end.at + size_of_sizes;
  if (begin > bytes.size())
    throw std::runtime_error("the file ends before the sizes of the compressed points");
  const std::size_t compressed_size = get_size(bytes, header.end.at);
  const std::size_t size = get_size(bytes, header.end.at + size_of_sizes / 2);
  if (compressed_size > bytes.size() - begin)
    throw std::runtime_error("the file ends after " + std::to_string(bytes.size() - begin) +
                             " of " + std::to_string(compressed_size) +
                             " bytes of compressed points");
  const std::size_t record_size = header.record_size();
  if (!has_size(header, size))
    header.leave_out_padding();
  if (!has_size(header, size))
    throw std::runtime_error("the compressed points have " + std::to_string(size) +
                             " bytes, but the header tells of " + std::to_string(header.count) +
                             " points of " + std::to_string(record_size) + " bytes");
  if (size / largest_lzf_ratio > compressed_size)
    throw std::runtime_error(std::to_string(compressed_size) + " bytes of LZF are no " +
                             std::to_string(size) + " bytes of points");
  const std::string points = decompress_lzf(bytes.data() + begin, compressed_size, size);
  return bytes.substr(0, header.end.at) + transpose(points, header, false) +
         bytes.substr(begin + compressed_size);
}

Compressed_file::Compressed_file(Bytes compressed, Anatomy records, bool leaves_out_padding)
    : Raw_file(std::move(records)), m_compressed(std::move(compressed)),
      m_leaves_out_padding(leaves_out_padding)
{}

void Compressed_file::write(const Target& target) const
{
  std::ostringstream out;
  Raw_file::write({out, target.path, target.format});
  const std::string records = out.str();
  if (records == bytes().view()) { // others compress in other ways
    target.out << m_compressed.view();
    return;
  }
  const Bytes as_bytes(records);
  Header header(as_bytes);
  if (m_leaves_out_padding)
    header.leave_out_padding();
  const std::size_t begin = header.end.at, size = header.count * header.record_size();
  const std::string compressed = compress_lzf(transpose(records.substr(begin, size), header, true));
  std::string sizes;
  append_size(sizes, compressed.size());
  append_size(sizes, size);
  target.out << records.substr(0, begin) << sizes << compressed << records.substr(begin + size);
}

} // namespace point_files::pcd
