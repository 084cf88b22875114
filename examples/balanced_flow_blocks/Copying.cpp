// SPDX-License-Identifier: GPL-3.0-or-later
#include "Copying.h"

#include "Block_writer.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

namespace balanced_flow_blocks {

using point_files::Invalid;
using point_files::Point_3;
using point_files::Vector_3;

Copying::Copying(Manifest& manifest)
    : m_manifest(manifest), m_copy(manifest.directory / "unsorted"),
      m_out(m_copy, manifest.has_normals), m_records(manifest.has_normals)
{}

void Copying::copy(Input_file& input, const point_files::Streamed_file& file, const Range& range,
                   const Normals& normals_of, const Progress& progress)
{
  std::uint64_t at = 0; // in the file
  file.for_each_chunk([&](const point_files::Chunk_of_points& chunk) {
    const std::uint64_t first = at, end = at += chunk.points.size();
    if (end <= range.begin || first >= range.end)
      return;
    const std::vector<Vector_3> normals = normals_of(chunk, first);
    m_records.resize(chunk.points.size());
    std::size_t valid = 0;
    for (std::uint64_t i = (std::max)(first, range.begin); i < (std::min)(end, range.end); ++i) {
      const std::size_t j = std::size_t(i - first);
      const Point_3& p = chunk.points[j];
      if (!is_valid(p, i, file, input))
        continue;
      for (int d = 0; d < 3; ++d) {
        m_records.set_value(valid, std::size_t(d), p[d]);
        if (m_manifest.has_normals)
          m_records.set_value(valid, std::size_t(d + 3), normals.empty() ? 0. : normals[j][d]);
      }
      m_records.set_number(valid++, input.first + i - range.begin);
    }
    m_records.resize(valid);
    m_frame.add(m_records);
    for (std::size_t i = 0; i < valid; ++i)
      m_out.append(m_records, i);
    m_count += valid;
    progress(double((std::min)(end, range.end) - range.begin) / double(range.end - range.begin));
  });
  if (at < range.end)
    throw std::runtime_error(input.path.string() + " ends after " + std::to_string(at) + " of " +
                             std::to_string(range.end) + " points");
  input.check_unchanged();
}

bool Copying::is_valid(const Point_3& p, std::uint64_t i, const point_files::Streamed_file& file,
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

void Copying::sort(const Progress& progress)
{
  m_out.flush();
  if (m_count == 0)
    throw std::runtime_error("there are no points that are valid");
  m_frame.end_pass();
  for (int pass = 1; pass < Frame_search::number_of_passes; ++pass) {
    for_each_records(m_copy, m_manifest.has_normals, [&](const Records& records) {
      m_frame.add(records);
      progress(.15 * pass);
    });
    m_frame.end_pass();
  }
  m_manifest.frame = m_frame.frame();
  Block_writer(m_manifest, m_count, progress.part(.5, 1.)).sort(m_copy);
  m_manifest.write();
}

} // namespace balanced_flow_blocks
