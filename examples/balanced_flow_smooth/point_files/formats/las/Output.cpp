// SPDX-License-Identifier: GPL-3.0-or-later
#include "Output.h"

#include "../../Spool_file.h"
#include "Bytes.h"
#include "Laz_records.h"
#include "fail.h"

#include <algorithm>
#include <fstream>
#include <limits>

namespace point_files::las {

namespace {

bool is_dropped(const Variable_record& record)
{
  return record.is(laszip_user_id, laszip_record_id) || record.user_id == "copc";
}

/// Where a place behind the points comes to be
std::uint64_t moved(std::uint64_t place, const Frame& frame, std::uint64_t rest_begin)
{
  for (const Range& range : frame.rest)
    rest_begin += (std::min)(range.end, (std::max)(range.begin, place)) - range.begin;
  return rest_begin;
}

/// Sets what the header tells of places behind the points.
void set_places(std::string& header, const Frame& frame, std::uint64_t rest_begin)
{
  const unsigned minor_version = get<std::uint8_t>(&header[at::version + 1]);
  const auto move = [&](std::size_t field) {
    const auto place = get<std::uint64_t>(&header[field]);
    if (place != 0)
      put(&header[field], moved(place, frame, rest_begin));
  };
  if (minor_version >= 3 && (get<std::uint16_t>(&header[at::global_encoding]) & 2) != 0)
    move(at::waveforms);
  if (minor_version < 4)
    return;
  if (frame.has_evlrs())
    move(at::evlrs);
  else if (get<std::uint32_t>(&header[at::evlr_count]) != 0)
    put(&header[at::evlrs], std::uint64_t(0));
  put(&header[at::evlr_count], std::uint32_t(frame.evlr_count));
}

/// \param out can seek if the points are compressed
void write_to(std::ostream& out, bool is_compressed, const Frame& frame,
              const std::function<void(Record_writer&)>& write_points)
{
  const std::string vlr =
      is_compressed ? laszip_vlr(frame.point_format, frame.record_size) : std::string();
  std::uint64_t points_begin =
      frame.header.size() + frame.new_vlrs.size() + vlr.size() + frame.gap.end - frame.gap.begin;
  for (const Range& range : frame.vlrs)
    points_begin += range.end - range.begin;
  if (points_begin > (std::numeric_limits<std::uint32_t>::max)())
    fail("the variable length records end at byte ", points_begin, ", too late for LAS");

  std::string header = frame.header;
  put(&header[at::points], std::uint32_t(points_begin));
  put(&header[at::vlr_count], std::uint32_t(frame.vlr_count + (is_compressed ? 1 : 0)));
  put(&header[at::point_format], std::uint8_t(frame.point_format | (is_compressed ? 0x80 : 0)));
  if (!is_compressed)
    set_places(header, frame, points_begin + frame.count * frame.record_size);
  const auto copy = [&](const Range& range) {
    if (range.begin != range.end)
      frame.input->copy(range.begin, range.end, out);
  };
  out.write(header.data(), std::streamsize(header.size()));
  std::for_each(frame.vlrs.begin(), frame.vlrs.end(), copy);
  out << frame.new_vlrs << vlr;
  copy(frame.gap);
  const auto writer = make_writer(out, is_compressed, frame.point_format, frame.record_size);
  write_points(*writer);
  writer->finish();
  if (is_compressed && out) { // only now it is known how long the points are
    const auto rest_begin = out.tellp();
    set_places(header, frame, std::uint64_t(std::streamoff(rest_begin)));
    out.seekp(0);
    out.write(header.data(), std::streamsize(header.size()));
    out.seekp(rest_begin);
  }
  std::for_each(frame.rest.begin(), frame.rest.end(), copy);
}

} // namespace

Frame::Frame(const Input& from, const Header& h, bool recodes)
    : header(h.bytes), point_format(h.point_format), record_size(h.record_size), count(h.count),
      input(&from), gap({h.vlrs_end, h.points_begin})
{
  for (const Variable_record& record : h.vlrs)
    if (!recodes || !is_dropped(record)) {
      vlrs.push_back({record.begin, record.end});
      ++vlr_count;
    }
  std::uint64_t begin = h.rest_begin(from);
  for (const Variable_record& record : h.evlrs)
    if (recodes && is_dropped(record)) {
      rest.push_back({begin, record.begin});
      begin = record.end;
    }
    else
      ++evlr_count;
  rest.push_back({begin, from.size()});
}

void write_file(const Target& target, const Frame& frame,
                const std::function<void(Record_writer&)>& write_points)
{
  const bool is_compressed = target.format.name == "laz";
  if (!is_compressed || !target.path.empty())
    return write_to(target.out, is_compressed, frame, write_points);
  const Spool_file spool; // for who goes back to the header
  std::ofstream out(spool.path(), std::ios::binary);
  write_to(out, is_compressed, frame, write_points);
  if (!out.flush())
    fail("writing to ", spool.path().string(), " failed");
  target.out << std::ifstream(spool.path(), std::ios::binary).rdbuf();
}

} // namespace point_files::las
