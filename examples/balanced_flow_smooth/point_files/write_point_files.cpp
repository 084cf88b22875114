// SPDX-License-Identifier: GPL-3.0-or-later
#include "write_point_files.h"

#include "Temporary_file.h"
#include "point_file_io.h"

#include <cstddef>
#include <deque>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>

namespace point_files {

namespace {

bool is_standard_stream(const std::filesystem::path& path) { return path == "-"; }

[[noreturn]] void fail_to_write(const std::filesystem::path& path, const std::string& why)
{
  throw std::runtime_error("cannot write " +
                           (is_standard_stream(path) ? "standard output" : path.string()) + ": " +
                           why);
}

/// Calls a function that writes a file, and adds the name of the file to what went wrong.
template <typename Function>
void try_to_write(const std::filesystem::path& path, const Function& function)
{
  try {
    function();
  }
  catch (const std::exception& e) {
    fail_to_write(path, e.what());
  }
}

} // namespace

void check_output(const std::filesystem::path& path, const Format* format)
{
  try_to_write(path, [&] {
    if (format)
      check_support(*format);
    if (is_standard_stream(path))
      return;
    if (std::filesystem::is_directory(path))
      throw std::runtime_error("this is a directory (--output-dir writes into one)");
    if (std::filesystem::exists(path) && !std::filesystem::is_regular_file(path))
      throw std::runtime_error("this is not a regular file");
    if (path.has_parent_path() && !std::filesystem::is_directory(path.parent_path()))
      throw std::runtime_error("there is no directory " + path.parent_path().string());
    const Temporary_file trial(path);
  });
}

bool write_point_files(const std::vector<Output>& outputs,
                       const std::function<bool()>& is_interrupted)
{
  std::deque<Temporary_file> files; // those that have a place
  for (const Output& output : outputs)
    try_to_write(output.path, [&] {
      if (is_standard_stream(output.path))
        return write_as(output.file, {std::cout, "", output.format});
      Temporary_file& out = files.emplace_back(output.path);
      write_as(output.file, {out.stream(), out.path(), output.format});
      out.finish();
    });
  if (is_interrupted() && !files.empty())
    return false;
  std::size_t placed = 0;
  try {
    for (; placed < files.size(); ++placed)
      try_to_write(files[placed].target(), [&] { files[placed].take_place(files.size() > 1); });
  }
  catch (...) {
    while (placed != 0)
      files[--placed].give_back_place();
    throw;
  }
  return true;
}

} // namespace point_files
