// SPDX-License-Identifier: GPL-3.0-or-later
#include "Input_order.h"

#include "Block_result.h"
#include "Record_stream.h"
#include "memory_use.h"
#include "smooth.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <system_error>

namespace balanced_flow_blocks {

namespace {

std::size_t values_of(const Manifest& manifest) { return manifest.writes_normals ? 6 : 3; }

} // namespace

Input_order::Input_order(const Manifest& manifest, const Progress& progress)
    : m_manifest(manifest), m_path(manifest.directory / "joined")
{
  const std::uint64_t count = manifest.number_of_points,
                      part_size = points_to_put_back(manifest.memory, manifest.writes_normals);
  const std::vector<std::filesystem::path> parts = distribute(part_size, progress.part(0., .5));
  const std::size_t width = values_of(manifest);
  Disk_file out(m_path, Disk_file::WRITE);
  std::vector<double> values;
  for (std::size_t part = 0; part < parts.size(); ++part) {
    const std::uint64_t first = part * part_size;
    values.assign(std::size_t((std::min)(part_size, count - first)) * width,
                  (std::numeric_limits<double>::quiet_NaN)());
    for_each_records(parts[part], manifest.writes_normals, [&](const Records& records) {
      for (std::size_t i = 0; i < records.size(); ++i)
        for (std::size_t c = 0; c < width; ++c)
          values[std::size_t(records.number(i) - first) * width + c] = records.value(i, c);
    });
    std::filesystem::remove(parts[part]);
    out.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(double));
    progress(.5 + .5 * double(part + 1) / double(parts.size()));
  }
}

Input_order::~Input_order()
{
  std::error_code ignored;
  std::filesystem::remove(m_path, ignored);
}

/// Distributes the results to files for so many numbers each.
std::vector<std::filesystem::path> Input_order::distribute(std::uint64_t part_size,
                                                           const Progress& progress) const
{
  std::vector<std::filesystem::path> files;
  std::vector<std::unique_ptr<Record_writer>> parts;
  for (std::uint64_t first = 0; first < m_manifest.number_of_points; first += part_size) {
    files.push_back(m_manifest.directory / ("unjoined." + std::to_string(files.size())));
    parts.push_back(std::make_unique<Record_writer>(files.back(), m_manifest.writes_normals,
                                                    std::size_t(2048)));
  }
  for (std::size_t block = 0; block < m_manifest.blocks.size(); ++block) {
    Block_result(m_manifest, block).for_each([&](const Records& records) {
      for (std::size_t i = 0; i < records.size(); ++i)
        parts[std::size_t(records.number(i) / part_size)]->append(records, i);
    });
    progress(double(block + 1) / double(m_manifest.blocks.size()));
  }
  for (const auto& part : parts)
    part->flush();
  return files;
}

Input_order::Points::Points(const Input_order& order, const Input_file& input,
                            const Progress& progress)
    : m_file(order.m_path, Disk_file::READ), m_manifest(order.m_manifest), m_first(input.first),
      m_progress(progress)
{}

void Input_order::Points::replace(std::uint64_t first, point_files::Chunk_of_points& chunk) const
{
  const std::size_t width = values_of(m_manifest);
  std::vector<double> values(chunk.points.size() * width);
  m_file.read((m_first + first) * width * sizeof(double), reinterpret_cast<char*>(values.data()),
              values.size() * sizeof(double));
  for (std::size_t i = 0; i < chunk.points.size(); ++i) {
    const double* const v = &values[i * width];
    if (std::isnan(v[0]))
      continue;
    chunk.points[i] = point_files::Point_3(v[0], v[1], v[2]);
    if (!chunk.normals.empty() &&
        !balanced_flow_smooth::keeps_normal(chunk.normals[i], m_manifest.settings.smoothing))
      chunk.normals[i] = point_files::Vector_3(v[3], v[4], v[5]);
  }
  m_progress(double(m_first + first) / double(m_manifest.number_of_points));
}

} // namespace balanced_flow_blocks
