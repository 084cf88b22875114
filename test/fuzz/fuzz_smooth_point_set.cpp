// SPDX-License-Identifier: GPL-3.0-or-later
// From the bytes of a file to smoothed points, as the program smooth_point_set goes: whatever the
// bytes are, either the result is finite or there is an exception. With clang++ -fsanitize=fuzzer this
// is a target of libFuzzer; otherwise it tries the files that are named on the command line.
#include "Point_set_io.h"

#include <CGAL/balanced_flow_smooth_point_set.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>
#include <string>

namespace {

void try_bytes(const std::string& bytes)
{
  Point_set_file file;
  try {
    std::istringstream in(bytes);
    if (bytes.compare(0, 3, "ply") == 0) {
      file.format = ".ply";
      point_set_io::read_ply(in, file);
    }
    else if (bytes.find("OFF") < 8) {
      file.format = ".off";
      point_set_io::read_off(in, file);
    }
    else {
      file.format = ".xyz";
      point_set_io::read_xyz(in, file);
    }
    if (file.points.size() <= 2000) // the readers are what is tried
      CGAL::balanced_flow_smooth_point_set<CGAL::Sequential_tag>(
          file.points, CGAL::parameters::number_of_iterations(2));
  }
  catch (const std::exception&) { // says what is wrong
    return;
  }
  for (const auto& index : file.points) {
    const auto& p = file.points.point(index);
    if (!(std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z())) &&
        file.points.size() <= 2000)
      std::abort();
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  try_bytes(std::string(reinterpret_cast<const char*>(data), size));
  return 0;
}

#ifndef BALANCED_FLOW_LIBFUZZER
int main(int argc, char** argv)
{
  for (int i = 1; i < argc; ++i) {
    std::ifstream in(argv[i], std::ios::binary);
    if (!in) {
      std::cerr << "cannot read " << argv[i] << std::endl;
      return EXIT_FAILURE;
    }
    try_bytes(std::string(std::istreambuf_iterator<char>(in), {}));
    std::cout << argv[i] << ": ok" << std::endl;
  }
  return EXIT_SUCCESS;
}
#endif
