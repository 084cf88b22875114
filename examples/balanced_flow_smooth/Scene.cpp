// SPDX-License-Identifier: GPL-3.0-or-later
#include "Scene.h"

#include "find_sides.h"

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace balanced_flow_smooth {

using point_files::Point_3;
using point_files::Point_file;
using point_files::Vector_3;

namespace {

bool any_has(const Point_files& files, const std::vector<Vector_3> Point_file::*vectors)
{
  return std::any_of(files.begin(), files.end(),
                     [&](const auto& file) { return !((*file).*vectors).empty(); });
}

/// Appends one vector for each point, null vectors if there are none.
void append(const std::vector<Vector_3>& vectors, std::size_t n, std::vector<Vector_3>& all)
{
  all.insert(all.end(), vectors.begin(), vectors.end());
  all.resize(all.size() + n - vectors.size(), CGAL::NULL_VECTOR);
}

} // namespace

Scene::Scene(const Point_files& files) : m_files(files)
{
  m_invalid.reserve(files.size());
  for (const auto& file : files)
    m_invalid.emplace_back(*file);
  const bool has_normals = any_has(files, &Point_file::normals);
  const bool has_views = any_has(files, &Point_file::sides);
  for (const auto& file : files)
    add(*file, has_normals, has_views);
}

void Scene::add(Point_file& file, bool has_normals, bool has_views)
{
  const std::size_t n = file.points.size();
  if (has_normals)
    append(file.normals, n, cloud.normals);
  if (is_single()) {
    swap_with(file);
    return;
  }
  if (has_views)
    append(file.sides, n, cloud.views);
  cloud.points.insert(cloud.points.end(), file.points.begin(), file.points.end());
  const std::uint32_t first =
      cloud.scans.empty() ? 0 : *std::max_element(cloud.scans.begin(), cloud.scans.end()) + 1;
  for (const std::uint32_t number : file.scans)
    cloud.scans.push_back(first + number);
  cloud.scans.resize(cloud.points.size(), first);
}

void Scene::swap_with(Point_file& file)
{
  cloud.points.swap(file.points);
  cloud.views.swap(file.sides);
  cloud.scans.swap(file.scans);
}

void Scene::give_back(const Smoothing_settings& s, std::vector<File_report>& reports)
{
  std::size_t first = 0;
  for (std::size_t f = 0; f < m_files.size(); ++f) {
    Point_file& file = *m_files[f];
    if (is_single())
      swap_with(file);
    else
      reports[f].movement = move_points(file, first);
    give_back_normals(file, first, s);
    first += file.points.size();
    m_invalid[f].put_back();
  }
}

Movement Scene::move_points(Point_file& file, std::size_t first) const
{
  Movement movement;
  double sum = 0.;
  for (std::size_t i = 0; i < file.points.size(); ++i) {
    const Point_3& after = cloud.points[first + i];
    movement.number_of_points += after != file.points[i] ? 1 : 0;
    sum += std::sqrt(CGAL::squared_distance(after, file.points[i]));
    file.points[i] = after;
  }
  movement.mean = file.points.empty() ? 0. : sum / double(file.points.size());
  return movement;
}

void Scene::give_back_normals(Point_file& file, std::size_t first,
                              const Smoothing_settings& s) const
{
  for (std::size_t i = 0; i < file.normals.size(); ++i) {
    Vector_3& normal = file.normals[i];
    if (keeps_normal(normal, s))
      continue;
    const bool was_known = is_known(normal);
    normal = cloud.normals[first + i];
    if (!was_known && !file.sides.empty() && file.sides[i] * normal < 0.)
      normal = -normal; // also where the view grazes
  }
}

void warn_of_distant_files(const Point_files& files)
{
  std::vector<CGAL::Bbox_3> boxes;
  for (const auto& file : files) {
    CGAL::Bbox_3 box;
    std::size_t next = 0;
    for (std::size_t i = 0; i < file->points.size(); ++i)
      if (next < file->invalid.size() && file->invalid[next] == i)
        ++next;
      else
        box += file->points[i].bbox();
    // tiles lie side by side
    const double margin =
        (std::max)({box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin(), 0.});
    boxes.emplace_back(box.xmin() - margin, box.ymin() - margin, box.zmin() - margin,
                       box.xmax() + margin, box.ymax() + margin, box.zmax() + margin);
  }
  for (std::size_t f = 0; f < files.size(); ++f) {
    bool is_near = files.size() == 1 || boxes[f].xmin() > boxes[f].xmax(); // or no points
    for (std::size_t g = 0; g < files.size() && !is_near; ++g)
      is_near = f != g && CGAL::do_overlap(boxes[f], boxes[g]);
    if (!is_near)
      files[f]->warnings.push_back("it lies apart from all other files: scans that are smoothed "
                                   "together must be registered, in the same coordinates");
  }
}

} // namespace balanced_flow_smooth
