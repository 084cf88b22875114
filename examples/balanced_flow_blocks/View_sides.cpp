// SPDX-License-Identifier: GPL-3.0-or-later
#include "View_sides.h"

#include "Copying.h"
#include "find_sides.h"
#include "run.h"
#include "settings_to_json.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>
#include <system_error>

namespace balanced_flow_blocks {

namespace {

using point_files::Chunk_of_points;
using point_files::Streamed_file;
using point_files::Vector_3;

const Vector_3& normal_of(const Chunk_of_points& chunk, std::size_t i)
{
  static const Vector_3 none = CGAL::NULL_VECTOR;
  return chunk.normals.empty() ? none : chunk.normals[i];
}

bool has_needs(const Streamed_file& file, const Copying::Range& range)
{
  bool is_any = false;
  std::uint64_t at = 0;
  file.for_each_chunk([&](const Chunk_of_points& chunk) {
    for (std::size_t i = 0; i < chunk.views.size(); ++i, ++at)
      is_any = is_any || (at >= range.begin && at < range.end &&
                          balanced_flow_smooth::needs_view(chunk.views[i], normal_of(chunk, i)));
  });
  return is_any;
}

/// A plan for the normals of a scan
Manifest manifest_of_scan(const Manifest& all, const Input_file& input,
                          const std::filesystem::path& directory, const Copying::Range& range)
{
  Manifest scan;
  scan.directory = directory;
  scan.settings = all.settings;
  scan.settings.smoothing = balanced_flow_smooth::settings_of_normals(all.settings.smoothing);
  scan.memory = all.memory;
  scan.block_size = all.block_size;
  scan.has_normals = scan.writes_normals = true;
  scan.number_of_points = range.end - range.begin;
  scan.inputs = {input};
  scan.inputs.front().first = 0;
  scan.inputs.front().count = scan.number_of_points;
  return scan;
}

bool is_same(const Manifest& a, const Manifest& b)
{
  const Input_file &i = a.inputs.front(), &j = b.inputs.front();
  return settings_to_json(a.settings) == settings_to_json(b.settings) && a.memory == b.memory &&
         a.block_size == b.block_size && i.path == j.path && i.size == j.size && i.time == j.time &&
         i.count == j.count;
}

/// A plan that is there already after an interruption, or a new one
Manifest plan_of_scan(const Manifest& all, const Input_file& input, const Streamed_file& file,
                      const std::filesystem::path& directory, const Copying::Range& range,
                      const Progress& progress)
{
  Manifest scan = manifest_of_scan(all, input, directory, range);
  if (Manifest::exists(directory)) {
    const Manifest planned = Manifest::read(directory);
    if (is_same(planned, scan))
      return planned;
  }
  std::filesystem::remove_all(directory);
  std::filesystem::create_directories(directory / "blocks");
  std::filesystem::create_directories(directory / "results");
  Copying copying(scan);
  const auto no_normals = [](const Chunk_of_points&, std::uint64_t) {
    return std::vector<Vector_3>();
  };
  copying.copy(scan.inputs.front(), file, range, no_normals, progress.part(0., .5));
  copying.sort(progress.part(.5, 1.));
  return scan;
}

} // namespace

/// The normals of the points of a scan, in their order
class View_sides::Scan_normals {
  const Manifest m_manifest;
  const Copying::Range m_range;
  const Progress m_silent;
  std::optional<Input_order> m_order;
  std::optional<Input_order::Points> m_points;

public:
  Scan_normals(Manifest manifest, const Copying::Range& range, const Progress& progress)
      : m_manifest(std::move(manifest)), m_range(range), m_silent([](double) { return true; })
  {
    smooth_all(m_manifest, 1, progress.part(0., .9));
    m_order.emplace(m_manifest, progress.part(.9, 1.));
    m_points.emplace(*m_order, m_manifest.inputs.front(), m_silent);
  }

  /// \param first the number of the first of some points in the file, which are all in the scan
  std::vector<Vector_3> normals(const Chunk_of_points& chunk, std::uint64_t first,
                                std::size_t begin, std::size_t end) const
  {
    Chunk_of_points found;
    found.points.assign(chunk.points.begin() + std::ptrdiff_t(begin),
                        chunk.points.begin() + std::ptrdiff_t(end));
    found.normals.assign(found.points.size(), CGAL::NULL_VECTOR);
    m_points->replace(first + begin - m_range.begin, found);
    return std::move(found.normals);
  }

  const Copying::Range& range() const { return m_range; }
};

View_sides::View_sides(const Manifest& manifest, const Streamed_files& files,
                       const Progress& progress)
    : m_directory(directory(manifest.directory)), m_normals(files.size())
{
  if (!manifest.settings.smoothing.makes_steps())
    return;
  for (std::size_t f = 0; f < files.size(); ++f) {
    const Input_file& input = manifest.inputs[f];
    if (!files[f]->has_views)
      continue;
    m_count = 0;
    const std::vector<std::uint64_t>& scans = files[f]->scans;
    for (std::size_t s = 0; s < scans.size(); ++s) {
      const Copying::Range range = {scans[s], s + 1 < scans.size() ? scans[s + 1] : input.count};
      const auto share = [&](std::uint64_t at) {
        return double(input.first + at) / double(manifest.number_of_points);
      };
      const Progress part = progress.part(share(range.begin), share(range.end));
      if (has_needs(*files[f], range))
        m_normals[f].push_back(std::make_unique<Scan_normals>(
            plan_of_scan(manifest, input, *files[f],
                         m_directory / (std::to_string(f) + "." + std::to_string(s)), range,
                         part.part(0., .2)),
            range, part.part(.2, 1.)));
    }
  }
}

View_sides::~View_sides() = default;

std::vector<Vector_3> View_sides::operator()(std::size_t file, const Chunk_of_points& chunk,
                                             std::uint64_t first)
{
  if (m_normals[file].empty() || chunk.views.empty())
    return chunk.normals;
  const std::uint64_t end = first + chunk.points.size();
  std::vector<Vector_3> sides = chunk.normals;
  sides.resize(chunk.points.size(), CGAL::NULL_VECTOR);
  for (const auto& scan : m_normals[file]) {
    if (scan->range().end <= first || scan->range().begin >= end)
      continue;
    const std::size_t begin = std::size_t((std::max)(scan->range().begin, first) - first),
                      last = std::size_t((std::min)(scan->range().end, end) - first);
    const std::vector<Vector_3> normals = scan->normals(chunk, first, begin, last);
    for (std::size_t i = begin; i < last; ++i)
      if (balanced_flow_smooth::needs_view(chunk.views[i], normal_of(chunk, i))) {
        sides[i] = balanced_flow_smooth::side_by_view(chunk.views[i], normals[i - begin]);
        *m_count += sides[i] != CGAL::NULL_VECTOR ? 1 : 0;
      }
  }
  return sides;
}

void View_sides::remove()
{
  m_normals.clear();
  std::error_code ignored;
  std::filesystem::remove_all(m_directory, ignored);
}

} // namespace balanced_flow_blocks
