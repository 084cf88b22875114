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

} // namespace

bool is_known(const Vector_3& normal)
{
  const bool is_finite =
      std::isfinite(normal.x()) && std::isfinite(normal.y()) && std::isfinite(normal.z());
  return is_finite && normal != CGAL::NULL_VECTOR;
}

bool needs_view(const Vector_3& view, const Vector_3& normal)
{
  return is_known(view) && !is_known(normal);
}

Smoothing_settings settings_of_normals(const Smoothing_settings& s)
{
  Smoothing_settings normals_only = s;
  normals_only.iterations = normals_only.relaxation_steps = 0;
  normals_only.fills_normals = true;
  return normals_only;
}

Vector_3 side_by_view(const Vector_3& view, const Vector_3& normal)
{
  // of the angle between them; the sign of a smaller one may be due to noise
  const double least_cosine = .2;
  if (!(std::abs(view * normal) >= least_cosine * std::sqrt(view.squared_length())))
    return CGAL::NULL_VECTOR;
  return view * normal < 0. ? -normal : normal;
}

std::size_t find_sides(Cloud& cloud, const Smoothing_settings& s, const Callback& callback)
{
  const std::size_t n = cloud.points.size();
  const auto needs = [&](std::size_t i) {
    return needs_view(cloud.views[i],
                      cloud.normals.empty() ? Vector_3(CGAL::NULL_VECTOR) : cloud.normals[i]);
  };
  if (cloud.views.empty() || !s.makes_steps())
    return 0;

  // The directions to the scanners are no normals: two scanners on the same side of a surface may see it
  // from opposite directions. Neither are the normals of all scans together, on a wall that is thinner than
  // the neighborhoods.
  const Smoothing_settings normals_only = settings_of_normals(s);
  Smoothing_report unused;
  const std::vector<Index_range> ranges = ranges_of_scans(cloud);
  Cloud single;
  single.normals.assign(n, CGAL::NULL_VECTOR);
  single.points.swap(cloud.points);
  bool is_canceled = false;
  for (const Index_range& range : ranges) {
    bool is_needed = false;
    for (std::size_t i = range.begin; i < range.end && !is_needed; ++i)
      is_needed = needs(i);
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
    if (needs(i)) {
      cloud.normals[i] = side_by_view(cloud.views[i], single.normals[i]);
      count += cloud.normals[i] != CGAL::NULL_VECTOR ? 1 : 0;
    }
  return count;
}

} // namespace balanced_flow_smooth
