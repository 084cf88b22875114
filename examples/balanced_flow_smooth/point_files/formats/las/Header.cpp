// SPDX-License-Identifier: GPL-3.0-or-later
#include "Header.h"

#include "Bytes.h"
#include "fail.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace point_files::las {

namespace {

constexpr std::size_t record_sizes[] = {20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};

} // namespace

std::size_t smallest_record(unsigned point_format) { return record_sizes[point_format]; }

std::int32_t Grid::integer(double coordinate, std::size_t axis, std::size_t point) const
{
  typedef std::numeric_limits<std::int32_t> Limits;
  const double integer = std::round((coordinate - offset[axis]) / scale[axis]);
  if (!(integer >= (Limits::min)() && integer <= (Limits::max)()))
    fail(axis_name(axis), " of points[", point, "] is ", coordinate,
         ", which the 32 bits of LAS can not hold with a scale of ", scale[axis],
         " and an offset of ", offset[axis]);
  return std::int32_t(integer);
}

Header::Header(const Input& input)
{
  read_size(input);
  read_points(input);
  read_vlrs(input);
  read_evlrs(input);
}

void Header::read_size(const Input& input)
{
  constexpr std::size_t smallest[] = {227, 227, 227, 235, 375}; // of versions 1.0 to 1.4
  if (input.size() < 4 || input.read(0, 4) != "LASF")
    fail("this is not a LAS file: it does not begin with LASF");
  if (input.size() < smallest[0])
    fail("the file ends at byte ", input.size(), ", within the header of LAS");
  const std::string start = input.read(0, smallest[0]);
  const unsigned major = get<std::uint8_t>(&start[at::version]);
  minor_version = get<std::uint8_t>(&start[at::version + 1]);
  if (major != 1 || minor_version >= std::size(smallest))
    fail("LAS ", major, ".", minor_version, " is not known, only 1.0 to 1.4");
  const std::size_t size = get<std::uint16_t>(&start[at::header_size]);
  if (size < smallest[minor_version])
    fail("the header tells its size as ", size, " bytes, but in LAS 1.", minor_version,
         " it has at least ", smallest[minor_version]);
  if (size > input.size())
    fail("the file ends at byte ", input.size(), ", within the header of ", size, " bytes");
  bytes = input.read(0, size);
}

void Header::read_points(const Input& input)
{
  points_begin = get<std::uint32_t>(&bytes[at::points]);
  if (points_begin < bytes.size() || points_begin > input.size())
    fail("the header tells that the points begin at byte ", points_begin,
         ", but they are between byte ", bytes.size(), ", where the header ends, and byte ",
         input.size(), ", where the file does");
  const unsigned format = get<std::uint8_t>(&bytes[at::point_format]);
  is_compressed = (format & 0x80) != 0;
  point_format = is_compressed ? format & 0x3f : format; // the bit between is one of old LAZ
  if (point_format >= std::size(record_sizes))
    fail("the point format ", point_format, " is not known, only 0 to 10");
  record_size = get<std::uint16_t>(&bytes[at::record_size]);
  if (record_size < smallest_record(point_format))
    fail("the header tells that a point has ", record_size,
         " bytes, but those of the point format ", point_format, " have at least ",
         smallest_record(point_format));
  read_count();
  if (!is_compressed && count > (input.size() - points_begin) / record_size)
    fail("the header announces ", count, " points of ", record_size, " bytes from byte ",
         points_begin, " on, but the file ends at byte ", input.size(), ", after ",
         (input.size() - points_begin) / record_size, " points");
  points_end = is_compressed ? 0 : points_begin + count * record_size;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    grid.scale[axis] = get<double>(&bytes[at::scale + 8 * axis]);
    grid.offset[axis] = get<double>(&bytes[at::offset + 8 * axis]);
    if (!std::isfinite(grid.scale[axis]) || grid.scale[axis] == 0.)
      fail("the scale of ", axis_name(axis), " is ", grid.scale[axis]);
    if (!std::isfinite(grid.offset[axis]))
      fail("the offset of ", axis_name(axis), " is ", grid.offset[axis]);
  }
}

void Header::read_count()
{
  count = get<std::uint32_t>(&bytes[at::legacy_count]);
  if (minor_version < 4)
    return;
  const std::uint64_t legacy_count = count;
  count = get<std::uint64_t>(&bytes[at::count]);
  if (legacy_count != 0 && legacy_count != count)
    fail("the header announces ", legacy_count, " points at byte ", at::legacy_count, ", but ",
         count, " at byte ", at::count);
}

void Header::read_vlrs(const Input& input)
{
  constexpr std::size_t head = 54;
  const std::uint32_t announced = get<std::uint32_t>(&bytes[at::vlr_count]);
  vlrs_end = bytes.size();
  for (std::uint32_t i = 0; i < announced; ++i) {
    Variable_record record = {"", 0, vlrs_end, vlrs_end + head, 0};
    if (record.data <= points_begin) {
      const std::string start = input.read(record.begin, head);
      record.user_id = get_text(&start[2], 16);
      record.id = get<std::uint16_t>(&start[18]);
      record.end = record.data + get<std::uint16_t>(&start[20]);
    }
    if (record.data > points_begin || record.end > points_begin)
      fail("the header announces ", announced, " variable length records, but number ", i + 1,
           ", from byte ", record.begin, " on, ends beyond byte ", points_begin,
           ", where the points begin");
    vlrs_end = record.end;
    vlrs.push_back(record);
  }
}

void Header::read_evlrs(const Input& input)
{
  const std::uint64_t earliest = is_compressed ? points_begin + 8 : points_end;
  const auto check_place = [&](std::uint64_t place, const char* what) {
    if (place < earliest || place > input.size())
      fail("the header tells that ", what, " begin at byte ", place,
           ", but they are between the points, until byte ", earliest,
           ", and the end of the file at byte ", input.size());
  };
  const bool has_waveforms = (get<std::uint16_t>(&bytes[at::global_encoding]) & 2) != 0;
  if (minor_version >= 3 && has_waveforms) {
    waveforms_begin = get<std::uint64_t>(&bytes[at::waveforms]);
    if (waveforms_begin != 0)
      check_place(waveforms_begin, "the waveforms");
  }
  const std::uint32_t announced =
      minor_version >= 4 ? get<std::uint32_t>(&bytes[at::evlr_count]) : 0;
  if (announced == 0)
    return;
  constexpr std::size_t head = 60;
  evlrs_begin = get<std::uint64_t>(&bytes[at::evlrs]);
  check_place(evlrs_begin, "the extended variable length records");
  std::uint64_t end = evlrs_begin;
  for (std::uint32_t i = 0; i < announced; ++i) {
    const std::uint64_t left = input.size() - end;
    Variable_record record = {"", 0, end, end + head, 0};
    std::uint64_t size = 0;
    if (left >= head) {
      const std::string start = input.read(end, head);
      record.user_id = get_text(&start[2], 16);
      record.id = get<std::uint16_t>(&start[18]);
      size = get<std::uint64_t>(&start[20]);
    }
    if (left < head || size > left - head)
      fail("the header announces ", announced, " extended variable length records, but number ",
           i + 1, ", from byte ", end, " on, ends beyond byte ", input.size(),
           ", where the file does");
    record.end = end = record.data + size;
    evlrs.push_back(record);
  }
}

std::uint64_t Header::rest_begin(const Input& input) const
{
  if (!is_compressed)
    return points_end;
  // how long the compressed points are is nowhere written
  std::uint64_t begin = input.size();
  for (const std::uint64_t place : {evlrs_begin, waveforms_begin})
    if (place != 0)
      begin = (std::min)(begin, place);
  return begin;
}

const Variable_record* Header::find(const char* user_id, unsigned id) const
{
  for (const auto* records : {&vlrs, &evlrs})
    for (const Variable_record& record : *records)
      if (record.is(user_id, id))
        return &record;
  return nullptr;
}

} // namespace point_files::las
