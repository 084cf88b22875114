// SPDX-License-Identifier: GPL-3.0-or-later
// From the bytes of a file to smoothed points and back to bytes, as the program balanced-flow-smooth
// goes. Whatever the bytes are: either there is an exception that says what is wrong, or the file is
// written as it was, byte by byte, and after smoothing all points are finite and the file is one of
// as many points. With clang++ -fsanitize=fuzzer this is a target of libFuzzer; otherwise it tries
// the files that are named on the command line.
#include "point_files/invalid_points.h"
#include "point_files/point_file_io.h"

#include <CGAL/balanced_flow_smooth_point_set.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>
#include <sstream>
#include <string>

using namespace point_files;

namespace {

void require(bool condition, const char* what)
{
  if (!condition) {
    std::cerr << "this does not hold: " << what << std::endl;
    std::abort();
  }
}

std::string to_bytes(const Point_file& file, const Format& to)
{
  std::ostringstream out;
  write_as(file, {out, "", to});
  return out.str();
}

/// \param format null: to be found from the bytes
/// \return whether the bytes are a file of points
bool try_bytes(const std::string& bytes, const Format* format)
{
  std::unique_ptr<Point_file> file;
  try {
    file = read_point_bytes(bytes, format, {});
  }
  catch (const std::exception&) { // says what is wrong
    return false;
  }
  require(to_bytes(*file, *file->format) == bytes, "what did not change is the same");

  const std::size_t size = file->points.size();
  Set_aside invalid_points(*file);
  if (size <= 500) // the readers are what is tried
    CGAL::balanced_flow_smooth_point_set<CGAL::Sequential_tag>(
        file->points, CGAL::parameters::number_of_iterations(2));
  for (const Point_3& p : file->points)
    require(std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z()),
            "all points are finite");
  invalid_points.put_back();
  if (bytes.size() % 2 == 1 && file->format->adds_normals)
    file->add_normals();
  for (const Format& to : all_formats()) {
    if (!to.library.empty()) // no writer of ours
      continue;
    std::string written;
    try {
      written = to_bytes(*file, to);
    }
    // words and numbers that have no place in another format, and points out of the range of LAS
    catch (const std::exception&) {
      require(&to != file->format || to.family == "las", "a file can be written in its own format");
      continue;
    }
    try {
      Read_options options;
      options.invalid = Invalid::KEEP; // also where they are an error by default
      require(read_point_bytes(written, &to, options)->points.size() == size,
              "the file has as many points as before");
    }
    catch (const std::exception& e) {
      require(false, e.what());
    }
  }
  return true;
}

/// Keeps and drops points that are not finite.
/// \param format null: to be found from the bytes
void try_invalid_points(const std::string& bytes, const Format* format)
{
  Read_options options;
  std::unique_ptr<Point_file> file;
  std::string written;
  try {
    options.invalid = Invalid::KEEP;
    file = read_point_bytes(bytes, format, options);
    require(to_bytes(*file, *file->format) == bytes, "what is kept is the same");
    options.invalid = Invalid::DROP;
    file = read_point_bytes(bytes, format, options);
    written = to_bytes(*file, *file->format);
  }
  catch (const std::exception&) { // says what is wrong
    return;
  }
  try {
    require(read_point_bytes(written, file->format, {})->points.size() ==
                file->number_of_points_to_write(),
            "only the invalid points are dropped");
  }
  catch (const std::exception& e) {
    require(false, e.what());
  }
}

/// The same as if the name of the file told each of the formats, for small files; or just the format that
/// the environment names, to try a single reader for long
bool try_formats(const std::string& bytes)
{
  const char* const name = std::getenv("POINT_SET_FLOW_FUZZED_FORMAT");
  const Format* const only = name ? find_format(name) : nullptr;
  require(only || !name, "the format of POINT_SET_FLOW_FUZZED_FORMAT is known");
  const bool is_good = try_bytes(bytes, only);
  try_invalid_points(bytes, only);
  if (only)
    return is_good;
  for (const Format& format : all_formats())
    if (bytes.size() < 2000 && format.library.empty())
      try_bytes(bytes, &format);
  return is_good;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  try_formats(std::string(reinterpret_cast<const char*>(data), size));
  return 0;
}

#ifndef POINT_SET_FLOW_LIBFUZZER
int main(int argc, char** argv)
{
  for (int i = 1; i < argc; ++i) {
    std::ifstream in(argv[i], std::ios::binary);
    if (!in) {
      std::cerr << "cannot read " << argv[i] << std::endl;
      return EXIT_FAILURE;
    }
    const bool is_good = try_formats(std::string(std::istreambuf_iterator<char>(in), {}));
    std::cout << argv[i] << (is_good ? ": read, smoothed, written" : ": refused") << std::endl;
  }
  return EXIT_SUCCESS;
}
#endif
