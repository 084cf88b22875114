// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan.h"

#include "Copying.h"
#include "Directory_lock.h"
#include "Disk_file.h"
#include "View_sides.h"
#include "memory_use.h"
#include "point_files/Streamed_file.h"
#include "point_files/Temporary_file.h"
#include "settings_to_json.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <string>
#include <system_error>

namespace balanced_flow_blocks {

namespace {

typedef std::vector<std::unique_ptr<point_files::Streamed_file>> Streamed_files;

/// Opens all inputs and enters them into the manifest.
Streamed_files open(const Plan_request& request, Manifest& manifest)
{
  const Settings& settings = request.settings;
  Streamed_files files;
  bool are_scans = settings.together; // or else tiles, which are parts of one
  for (const auto& [path, output] : request.files) {
    Input_file input;
    input.path = std::filesystem::absolute(path).lexically_normal();
    input.output = output.empty() ? request.directory / "smoothed" / path.filename() : output;
    input.output = std::filesystem::absolute(input.output).lexically_normal();
    const auto& file = *files.emplace_back(point_files::open_streamed_file(
        path, settings.input_format,
        {false, settings.columns, settings.invalid, settings.zeros_are_invalid}));
    input.look_at_file();
    input.format = file.format->name;
    input.first = manifest.number_of_points;
    input.count = file.count;
    for (const std::uint64_t scan : file.scans)
      manifest.scans.push_back(input.first + scan);
    are_scans = are_scans || file.scans.size() > 1 || file.has_views;
    manifest.writes_normals = manifest.writes_normals || file.has_normals;
    manifest.number_of_points += input.count;
    manifest.inputs.push_back(input);
  }
  if (!are_scans || manifest.scans.size() == 1)
    manifest.scans.clear();
  return files;
}

/// Whether a directory was planned for the same.
bool is_same(const Manifest& planned, const Plan_request& request)
{
  if (settings_to_json(planned.settings) != settings_to_json(request.settings) ||
      planned.inputs.size() != request.files.size() || planned.memory != request.memory ||
      (request.block_size != 0 && planned.block_size != request.block_size))
    return false;
  for (std::size_t i = 0; i < request.files.size(); ++i) {
    if (planned.inputs[i].path !=
        std::filesystem::absolute(request.files[i].first).lexically_normal())
      return false;
    planned.inputs[i].check_unchanged();
  }
  return true;
}

void check_names(const std::vector<Input_file>& inputs, bool may_replace)
{
  std::set<std::filesystem::path> outputs;
  for (const Input_file& input : inputs) {
    if (!outputs.insert(input.output).second)
      throw std::runtime_error("two inputs would be written to " + input.output.string());
    std::error_code is_new;
    for (const Input_file& other : inputs)
      if (!may_replace && std::filesystem::equivalent(input.output, other.path, is_new))
        throw std::runtime_error("the output " + input.output.string() + " is an input, too");
  }
}

void make_empty(const std::filesystem::path& directory)
{
  std::filesystem::remove_all(directory);
  std::filesystem::create_directory(directory);
}

/// Removes what a run has left behind that was killed.
void remove_remains(const std::filesystem::path& directory)
{
  point_files::remove_abandoned(directory, [](const std::string& name) {
    return name == "manifest.json" || name == "pages";
  });
  remove_files(directory, "unsorted");
}

} // namespace

Plan_request request_of(const Settings& settings, const std::filesystem::path& directory,
                        std::vector<std::pair<std::filesystem::path, std::filesystem::path>> files)
{
  return {
      directory, std::move(files), settings, memory_from_text(settings.memory), settings.block_size,
      false};
}

std::vector<std::filesystem::path> files_of(const std::vector<std::filesystem::path>& inputs)
{
  std::vector<std::filesystem::path> files;
  for (const std::filesystem::path& input : inputs) {
    if (!std::filesystem::is_directory(input)) {
      files.push_back(input);
      continue;
    }
    const std::size_t before = files.size();
    for (const auto& entry : std::filesystem::directory_iterator(input)) {
      const std::string extension = entry.path().extension().string();
      if (entry.is_regular_file() && !extension.empty() &&
          point_files::find_format(extension.substr(1)))
        files.push_back(entry.path());
    }
    if (files.size() == before)
      throw std::runtime_error("there are no point files in the directory " + input.string());
    std::sort(files.begin() + std::ptrdiff_t(before), files.end());
  }
  return files;
}

Manifest plan(const Plan_request& request, const Progress& progress)
{
  const std::filesystem::path& directory = request.directory;
  std::filesystem::create_directories(directory);
  const Directory_lock lock(directory, "plan");
  if (Manifest::exists(directory)) {
    Manifest planned = Manifest::read(directory);
    if (!is_same(planned, request))
      throw std::runtime_error(directory.string() +
                               " is planned for other files or settings: use another directory");
    return planned;
  }
  Manifest manifest;
  manifest.directory = directory;
  manifest.settings = request.settings;
  manifest.memory = request.memory;
  manifest.block_size =
      request.block_size != 0 ? request.block_size : points_of_block(request.memory);
  auto files = open(request, manifest);
  check_names(manifest.inputs, request.may_replace_inputs);
  View_sides sides(manifest, files, progress.part(0., .6));
  manifest.has_normals = manifest.writes_normals || sides.are_any();
  remove_remains(directory);
  make_empty(directory / "blocks");
  make_empty(directory / "results");
  {
    const double begin = sides.are_any() ? .6 : 0., middle = begin + (1. - begin) * .4;
    Copying copying(manifest);
    for (std::size_t f = 0; f < files.size(); ++f) {
      Input_file& input = manifest.inputs[f];
      const auto share = [&](std::uint64_t number) {
        return begin + (middle - begin) * double(number) / double(manifest.number_of_points);
      };
      copying.copy(
          input, *files[f], {0, input.count},
          [&](const point_files::Chunk_of_points& chunk, std::uint64_t first) {
            return sides(f, chunk, first);
          },
          progress.part(share(input.first), share(input.first + input.count)));
      files[f].reset();
    }
    manifest.sided_points = sides.count();
    copying.sort(progress.part(middle, 1.));
  }
  sides.remove();
  return manifest;
}

} // namespace balanced_flow_blocks
