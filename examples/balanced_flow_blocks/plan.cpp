// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan.h"

#include "Block_writer.h"
#include "Directory_lock.h"
#include "Frame_search.h"
#include "Record_stream.h"
#include "memory_use.h"
#include "point_files/Streamed_file.h"
#include "settings_to_json.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>

namespace balanced_flow_blocks {

namespace {

using point_files::Invalid;
using point_files::Point_3;
using point_files::Vector_3;

/// Copies the points of the inputs to one file.
class Copying {
  Manifest& m_manifest;
  const std::vector<std::unique_ptr<point_files::Streamed_file>>& m_files;
  Record_writer m_out;
  Frame_search& m_frame;
  Records m_records;

public:
  Copying(Manifest& manifest, const std::vector<std::unique_ptr<point_files::Streamed_file>>& files,
          const std::filesystem::path& copy, Frame_search& frame)
      : m_manifest(manifest), m_files(files), m_out(copy, manifest.has_normals), m_frame(frame),
        m_records(manifest.has_normals)
  {}

  void operator()(const Progress& progress)
  {
    for (std::size_t f = 0; f < m_files.size(); ++f) {
      Input_file& input = m_manifest.inputs[f];
      std::uint64_t done = 0;
      m_files[f]->for_each_chunk([&](const point_files::Chunk_of_points& chunk) {
        m_records.resize(chunk.points.size());
        std::size_t valid = 0;
        for (std::size_t i = 0; i < chunk.points.size(); ++i)
          if (is_valid(chunk.points[i], done + i, *m_files[f], input))
            set(valid++, chunk, i, input.first + done + i);
        m_records.resize(valid);
        m_frame.add(m_records);
        for (std::size_t i = 0; i < valid; ++i)
          m_out.append(m_records, i);
        done += chunk.points.size();
        progress(double(input.first + done) / double(m_manifest.number_of_points));
      });
      if (done != input.count)
        throw std::runtime_error(input.path.string() + " ends after " + std::to_string(done) +
                                 " of " + std::to_string(input.count) + " points");
      input.check_unchanged();
    }
    m_out.flush();
  }

private:
  bool is_valid(const Point_3& p, std::uint64_t i, const point_files::Streamed_file& file,
                Input_file& input) const
  {
    const bool is_finite = std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
    const bool with_zeros = file.zeros_are_invalid || m_manifest.settings.zeros_are_invalid;
    if (is_finite && !(with_zeros && p == Point_3(CGAL::ORIGIN)))
      return true;
    const Invalid invalid = m_manifest.settings.invalid;
    if (invalid == Invalid::ERROR || (invalid == Invalid::BY_FORMAT && !file.defines_invalid)) {
      std::ostringstream message;
      message << "cannot read " << input.path.string() << ": points[" << i << "] is (" << p.x()
              << ", " << p.y() << ", " << p.z() << "), "
              << (is_finite ? "which counts as invalid" : "but coordinates must be finite")
              << " (--invalid keep leaves such points as they are)";
      throw std::runtime_error(message.str());
    }
    ++input.invalid;
    return false;
  }

  void set(std::size_t to, const point_files::Chunk_of_points& chunk, std::size_t i,
           std::uint64_t number)
  {
    for (int d = 0; d < 3; ++d) {
      m_records.set_value(to, std::size_t(d), chunk.points[i][d]);
      if (m_manifest.has_normals)
        m_records.set_value(to, std::size_t(d + 3),
                            chunk.normals.empty() ? 0. : chunk.normals[i][d]);
    }
    m_records.set_number(to, number);
  }
};

/// Opens all inputs and enters them into the manifest.
std::vector<std::unique_ptr<point_files::Streamed_file>> open(const Plan_request& request,
                                                              Manifest& manifest)
{
  const Settings& settings = request.settings;
  std::vector<std::unique_ptr<point_files::Streamed_file>> files;
  for (const auto& [path, output] : request.files) {
    Input_file input;
    input.path = std::filesystem::absolute(path).lexically_normal();
    input.output = output.empty() ? request.directory / "smoothed" / path.filename() : output;
    input.output = std::filesystem::absolute(input.output).lexically_normal();
    files.push_back(point_files::open_streamed_file(
        path, settings.input_format,
        {false, settings.columns, settings.invalid, settings.zeros_are_invalid}));
    input.look_at_file();
    input.format = files.back()->format->name;
    input.first = manifest.number_of_points;
    input.count = files.back()->count;
    manifest.has_normals = manifest.has_normals || files.back()->has_normals;
    manifest.writes_normals = manifest.writes_normals || files.back()->has_normals;
    manifest.number_of_points += input.count;
    manifest.inputs.push_back(input);
  }
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
  make_empty(directory / "blocks"); // of a run that was killed
  make_empty(directory / "results");

  const std::filesystem::path unsorted = directory / "unsorted";
  Frame_search frame;
  Copying(manifest, files, unsorted, frame)(progress.part(0., .4));
  files.clear();
  frame.end_pass();
  const std::uint64_t count =
      std::filesystem::file_size(unsorted) / Records::bytes_of(manifest.has_normals);
  if (count == 0)
    throw std::runtime_error("there are no points that are valid");
  for (int pass = 1; pass < Frame_search::number_of_passes; ++pass) {
    for_each_records(unsorted, manifest.has_normals, [&](const Records& records) {
      frame.add(records);
      progress(.4 + .1 * pass);
    });
    frame.end_pass();
  }
  manifest.frame = frame.frame();
  Block_writer(manifest, count, progress.part(.7, 1.)).sort(unsorted);
  manifest.write();
  return manifest;
}

} // namespace balanced_flow_blocks
