// SPDX-License-Identifier: GPL-3.0-or-later
#include "Laz_records.h"

#include "fail.h"

#ifdef POINT_SET_FLOW_WITH_LASZIP
#include "Bytes.h"
#include "Laszip_point.h"

#include <laszip/laszip_api.h>

#include <utility>
#endif

namespace point_files::las {

#ifndef POINT_SET_FLOW_WITH_LASZIP

namespace {

[[noreturn]] void fail_without_laszip()
{
  fail("the points are compressed (LAZ), but this program was built without LASzip: install it "
       "(liblaszip-dev in Debian 13 and Ubuntu 24.04), and build the program again");
}

} // namespace

bool has_laszip() { return false; }

std::unique_ptr<Record_reader> make_laz_reader(const Input&, const Header&)
{
  fail_without_laszip();
}

std::unique_ptr<Record_writer> make_laz_writer(std::ostream&, unsigned, std::size_t)
{
  fail_without_laszip();
}

std::string laszip_vlr(unsigned, std::size_t) { fail_without_laszip(); }

#else

namespace {

/// What LASzip calls a pointer, with its point
class Laszip {
  laszip_POINTER m_laszip = nullptr;

public:
  laszip_point_struct* point = nullptr;

  Laszip()
  {
    if (laszip_create(&m_laszip) != 0 || laszip_get_point_pointer(m_laszip, &point) != 0)
      fail("LASzip can not be used");
  }
  ~Laszip()
  {
    // it frees nothing of what is still open, and it is no error that matters if nothing is
    laszip_close_reader(m_laszip);
    laszip_close_writer(m_laszip);
    laszip_destroy(m_laszip);
  }

  /// Opens a reader. One that failed is not destroyed: LASzip would free what it never had.
  void open(std::istream& in)
  {
    laszip_BOOL is_compressed = 0;
    if (laszip_open_reader_stream(m_laszip, in, &is_compressed) != 0)
      fail_of(std::exchange(m_laszip, nullptr), "the compressed points can not be read");
  }
  Laszip(const Laszip&) = delete;
  Laszip& operator=(const Laszip&) = delete;

  operator laszip_POINTER() const { return m_laszip; }

  /// Throws `std::runtime_error` with what LASzip says if a function of it has failed.
  void check(laszip_I32 result, const std::string& what) const
  {
    if (result != 0)
      fail_of(m_laszip, what);
  }

  void prepare_writing(unsigned point_format, std::size_t record_size) const
  {
    check(
        laszip_set_point_type_and_size(m_laszip, laszip_U8(point_format), laszip_U16(record_size)),
        "LASzip can not compress these points");
    check(laszip_request_native_extension(m_laszip, 1), "LASzip can not compress these points");
  }

private:
  [[noreturn]] static void fail_of(laszip_POINTER laszip, const std::string& what)
  {
    laszip_CHAR* reason = nullptr;
    laszip_get_error(laszip, &reason);
    fail(what, " (", reason ? reason : "LASzip tells no reason", ")");
  }
};

/// LASzip believes the list of fields that the file gives it, even if it has one of them twice.
void check_fields(const std::string& codec, const Header& header)
{
  const std::string expected = laszip_vlr(header.point_format, header.record_size).substr(54);
  bool is_same = codec.size() == expected.size() && codec.compare(32, 2, expected, 32, 2) == 0;
  for (std::size_t i = 34; is_same && i < codec.size(); i += 6) // type, size, version of the codec
    is_same = codec.compare(i, 4, expected, i, 4) == 0;
  if (!is_same)
    fail("the record \"", laszip_user_id, "\" does not fit records of point format ",
         header.point_format, " with ", header.record_size, " bytes");
}

/// LASzip does not look whether what it reads is the table of chunks, without which it reads garbage
/// from files whose chunks differ in size, and it stops in silence after too few points.
void check_chunks(const Input& input, const Header& header)
{
  const Variable_record* const vlr = header.find(laszip_user_id, laszip_record_id);
  if (!vlr || vlr->end - vlr->data < 34)
    fail("the points are compressed, but there is no complete record \"", laszip_user_id, "\"");
  const std::string codec = input.read(vlr->data, std::size_t(vlr->end - vlr->data));
  check_fields(codec, header);
  const bool has_chunks = get<std::uint16_t>(&codec[0]) != 1;
  if (!has_chunks || header.count == 0)
    return;
  const std::uint64_t first = header.points_begin + 8;
  if (input.size() < first + 8)
    fail("the file ends at byte ", input.size(), ", within the compressed points");
  std::uint64_t table = get<std::uint64_t>(input.read(header.points_begin, 8).data());
  if (table == ~std::uint64_t(0)) // written by somebody who could not go back
    table = get<std::uint64_t>(input.read(input.size() - 8, 8).data());
  if (table < first || table > input.size() - 8)
    fail("the compressed points tell that their chunk table begins at byte ", table,
         ", but it is between byte ", first, " and the end of the file at byte ", input.size());
  const std::string start = input.read(table, 8);
  const std::uint64_t chunks = get<std::uint32_t>(&start[4]);
  const std::uint32_t chunk_size = get<std::uint32_t>(&codec[12]);
  const bool is_variable = chunk_size == ~std::uint32_t(0);
  if (get<std::uint32_t>(&start[0]) != 0 || chunk_size == 0)
    fail("there is no chunk table of the compressed points at byte ", table);
  if (is_variable ? chunks > header.count : chunks != (header.count + chunk_size - 1) / chunk_size)
    fail("the header announces ", header.count, " points, but the chunk table at byte ", table,
         " has ", chunks, " chunks",
         is_variable ? "" : " of " + std::to_string(chunk_size) + " points");
}

class Laz_reader : public Record_reader {
  std::istream& m_in;
  Laszip m_laszip;
  Laszip_point m_point;
  std::uint64_t m_done = 0, m_count;
  std::string m_record;

public:
  Laz_reader(const Input& input, const Header& header)
      : m_in(input.stream()), m_point(header.point_format), m_count(header.count),
        m_record(header.record_size, '\0')
  {
    m_laszip.open(m_in);
  }

  char* next() override
  {
    const laszip_I32 result = laszip_read_point(m_laszip);
    if (result != 0 || m_in.eof())
      m_laszip.check(1, "the compressed points are not complete: number " +
                            std::to_string(m_done + 1) + " of " + std::to_string(m_count) +
                            " can not be read");
    ++m_done;
    m_point.get(*m_laszip.point, m_record);
    return m_record.data();
  }
};

class Laz_writer : public Record_writer {
  Laszip m_laszip;
  Laszip_point m_point;
  std::size_t m_record_size;

public:
  Laz_writer(std::ostream& out, unsigned point_format, std::size_t record_size)
      : m_point(point_format), m_record_size(record_size)
  {
    m_laszip.prepare_writing(point_format, record_size);
    m_laszip.check(laszip_open_writer_stream(m_laszip, out, 1, 1),
                   "the points can not be compressed");
  }

  void write(const char* record) override
  {
    m_point.set(*m_laszip.point, record, m_record_size);
    m_laszip.check(laszip_write_point(m_laszip), "a point can not be compressed");
  }

  void finish() override
  {
    m_laszip.check(laszip_close_writer(m_laszip), "the points can not be compressed");
  }
};

} // namespace

bool has_laszip() { return true; }

std::unique_ptr<Record_reader> make_laz_reader(const Input& input, const Header& header)
{
  check_chunks(input, header);
  return std::make_unique<Laz_reader>(input, header);
}

std::unique_ptr<Record_writer> make_laz_writer(std::ostream& out, unsigned point_format,
                                               std::size_t record_size)
{
  return std::make_unique<Laz_writer>(out, point_format, record_size);
}

std::string laszip_vlr(unsigned point_format, std::size_t record_size)
{
  const Laszip laszip;
  laszip.prepare_writing(point_format, record_size);
  laszip_U8* bytes = nullptr;
  laszip_U32 size = 0;
  laszip.check(laszip_create_laszip_vlr(laszip, &bytes, &size),
               "LASzip can not compress these points");
  return std::string(reinterpret_cast<const char*>(bytes), size);
}

#endif

} // namespace point_files::las
