// SPDX-License-Identifier: GPL-3.0-or-later
#include "find_sides.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace balanced_flow_smooth {

using point_files::Vector_3;

namespace {

/// Where the points of each scan are
std::vector<Index_range> ranges_of_scans(const Cloud& cloud)
{
  if (cloud.scans.empty())
    return {{0, cloud.points.size()}};
  std::vector<Index_range> ranges;
  for (std::size_t i = 0; i < cloud.scans.size(); ++i) {
    if (i == 0 || cloud.scans[i] != cloud.scans[i - 1])
      ranges.push_back({i, i});
    ++ranges.back().end;
  }
  return ranges;
}

/// Whether a scanner saw the surface from a place that tells its side, for certain
bool is_clear(const Vector_3& view, const Vector_3& normal)
{
  // of the angle between them; the sign of a smaller one may be due to noise
  const double least_cosine = .2;
  return std::abs(view * normal) >= least_cosine * std::sqrt(view.squared_length());
}

} // namespace

bool is_known(const Vector_3& normal)
{
  const bool is_finite =
      std::isfinite(normal.x()) && std::isfinite(normal.y()) && std::isfinite(normal.z());
  return is_finite && normal != CGAL::NULL_VECTOR;
}

std::size_t find_sides(Cloud& cloud, const Smoothing_settings& s, const Callback& callback)
{
  const std::size_t n = cloud.points.size();
  const auto needs_view = [&](std::size_t i) {
    return is_known(cloud.views[i]) && (cloud.normals.empty() || !is_known(cloud.normals[i]));
  };
  if (cloud.views.empty() || !s.makes_steps())
    return 0;

  // The directions to the scanners are no normals: two scanners on the same side of a surface may see it
  // from opposite directions. Neither are the normals of all scans together, on a wall that is thinner than
  // the neighborhoods.
  Smoothing_settings normals_only = s;
  normals_only.iterations = normals_only.relaxation_steps = 0;
  Smoothing_report unused;
  Cloud single;
  single.normals.assign(n, CGAL::NULL_VECTOR);
  single.points.swap(cloud.points);
  bool is_canceled = false;
  for (const Index_range& range : ranges_of_scans(cloud)) {
    bool is_needed = false;
    for (std::size_t i = range.begin; i < range.end && !is_needed; ++i)
      is_needed = needs_view(i);
    const auto ask = [&](double share) {
      const double before = double(range.begin), size = double(range.end - range.begin);
      is_canceled = is_canceled || !callback((before + share * size) / double(n));
      return !is_canceled;
    };
    if (is_needed && !is_canceled)
      smooth(single, range, normals_only, ask, unused);
  }
  single.points.swap(cloud.points);
  if (is_canceled)
    return 0;

  std::size_t count = 0;
  cloud.normals.resize(n, CGAL::NULL_VECTOR);
  for (std::size_t i = 0; i < n; ++i)
    if (needs_view(i) && is_clear(cloud.views[i], single.normals[i])) {
      const Vector_3& normal = single.normals[i];
      cloud.normals[i] = normal * cloud.views[i] < 0. ? -normal : normal;
      ++count;
    }
  return count;
}

} // namespace balanced_flow_smooth
