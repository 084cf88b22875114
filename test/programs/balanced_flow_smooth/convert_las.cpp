// SPDX-License-Identifier: GPL-3.0-or-later
// LAS to LAZ and back with nothing but LASzip, for tests of ours: convert_las INPUT OUTPUT. Of what is
// behind the points, LASzip keeps nothing.
#include <laszip/laszip_api.h>

#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <string>

namespace {

struct Laszip {
  laszip_POINTER pointer = nullptr;

  Laszip() { laszip_create(&pointer); }
  ~Laszip() { laszip_destroy(pointer); }
  Laszip(const Laszip&) = delete;
  Laszip& operator=(const Laszip&) = delete;

  void check(laszip_I32 result) const
  {
    laszip_CHAR* message = nullptr;
    if (result == 0)
      return;
    laszip_get_error(pointer, &message);
    throw std::runtime_error(message ? message : "LASzip failed");
  }
};

bool ends_with(const std::string& text, const std::string& end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

void convert(const char* from, const char* to)
{
  const Laszip in, out;
  laszip_BOOL is_compressed = 0;
  laszip_header_struct* header = nullptr;
  laszip_point_struct* point = nullptr;
  in.check(laszip_open_reader(in.pointer, from, &is_compressed));
  in.check(laszip_get_header_pointer(in.pointer, &header));
  in.check(laszip_get_point_pointer(in.pointer, &point));
  const laszip_U64 count = header->number_of_point_records != 0
                               ? header->number_of_point_records
                               : header->extended_number_of_point_records;
  out.check(laszip_set_header(out.pointer, header));
  out.check(laszip_preserve_generating_software(out.pointer, 1));
  out.check(laszip_request_native_extension(out.pointer, 1));
  out.check(laszip_open_writer(out.pointer, to, ends_with(to, ".laz")));
  for (laszip_U64 i = 0; i < count; ++i) {
    in.check(laszip_read_point(in.pointer));
    out.check(laszip_set_point(out.pointer, point));
    out.check(laszip_write_point(out.pointer));
  }
  out.check(laszip_close_writer(out.pointer));
  in.check(laszip_close_reader(in.pointer));
}

} // namespace

int main(int argc, char** argv)
{
  if (argc != 3)
    return EXIT_FAILURE;
  try {
    convert(argv[1], argv[2]);
    return EXIT_SUCCESS;
  }
  catch (const std::exception& e) {
    std::cerr << argv[1] << ": " << e.what() << std::endl;
    return EXIT_FAILURE;
  }
}
