// SPDX-License-Identifier: GPL-3.0-or-later
#include "join.h"

#include "Block_result.h"
#include "Directory_lock.h"
#include "Disk_file.h"
#include "Input_order.h"
#include "View_sides.h"
#include "Written_outputs.h"
#include "point_files/Streamed_file.h"
#include "point_files/Temporary_file.h"
#include "point_files/point_file_io.h"
#include "point_files/write_point_files.h"

#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

namespace balanced_flow_blocks {

namespace {

std::unique_ptr<point_files::Streamed_file> open(const Manifest& manifest, const Input_file& input)
{
  input.check_unchanged();
  const Settings& settings = manifest.settings;
  auto file = point_files::open_streamed_file(
      input.path, settings.input_format,
      {false, settings.columns, settings.invalid, settings.zeros_are_invalid});
  if (file->count != input.count)
    throw std::runtime_error(input.path.string() + " has " + std::to_string(file->count) +
                             " points now, and had " + std::to_string(input.count));
  return file;
}

void write(const Manifest& manifest, const Input_file& input, const Input_order& order,
           const Progress& progress)
{
  const auto file = open(manifest, input);
  std::filesystem::create_directories(input.output.parent_path());
  point_files::check_output(input.output, file->format);
  try {
    point_files::Temporary_file out(input.output);
    file->write({out.stream(), out.path(), *file->format},
                Input_order::Points(order, input, progress));
    input.check_unchanged();
    out.take_place();
  }
  catch (const std::exception& e) {
    throw std::runtime_error("cannot write " + input.output.string() + ": " + e.what());
  }
}

/// Removes what was left behind when a process was killed.
void remove_remains(const Manifest& manifest)
{
  remove_files(manifest.directory, "unjoined");
  remove_files(manifest.directory, "joined");
  std::error_code ignored; // of a plan that was killed when it was done
  std::filesystem::remove_all(View_sides::directory(manifest.directory), ignored);
  std::map<std::filesystem::path, std::set<std::string>> names; // of each directory
  for (const Input_file& input : manifest.inputs)
    names[input.output.parent_path()].insert(input.output.filename());
  for (const auto& [directory, outputs] : names)
    point_files::remove_abandoned(directory, [&outputs = outputs](const std::string& name) {
      return outputs.count(name) != 0;
    });
}

} // namespace

balanced_flow_smooth::Smoothing_report join(const Manifest& manifest, const Progress& progress)
{
  const Directory_lock lock(manifest.directory, "join");
  Report_sum sum;
  for (std::size_t block = 0; block < manifest.blocks.size(); ++block)
    sum.add(Block_result(manifest, block).report()); // before any work
  for (const Input_file& input : manifest.inputs)
    input.check_unchanged();
  remove_remains(manifest);
  Written_outputs written(manifest);
  std::vector<std::size_t> missing;
  for (std::size_t i = 0; i < manifest.inputs.size(); ++i)
    if (!written.has(i))
      missing.push_back(i);
  if (missing.empty())
    return sum.report();
  const Input_order order(manifest, progress.part(0., .5));
  const Progress writing = progress.part(.5, 1.);
  for (const std::size_t i : missing) {
    write(manifest, manifest.inputs[i], order, writing);
    written.add(i);
  }
  return sum.report();
}

} // namespace balanced_flow_blocks
