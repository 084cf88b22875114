// SPDX-License-Identifier: GPL-3.0-or-later
#include "invalid_points.h"

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

namespace point_files {

namespace {

bool is_finite(const Point_3& p)
{
  return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
}

[[noreturn]] void refuse(const Point_file& file)
{
  const std::size_t i = file.invalid.front();
  const Point_3& p = file.points[i];
  std::ostringstream reason;
  reason << "points[" << i << "] is (" << p.x() << ", " << p.y() << ", " << p.z() << "), "
         << (is_finite(p) ? "which counts as invalid" : "but coordinates must be finite")
         << " (--invalid keeps or drops such points)";
  throw std::runtime_error(reason.str());
}

/// Removes the elements at ascending places, and returns them.
template <typename T>
std::vector<T> take_out(std::vector<T>& all, const std::vector<std::size_t>& places)
{
  std::vector<T> taken;
  if (all.empty() || places.empty())
    return taken;
  std::size_t to = places.front();
  for (std::size_t from = to, next = 0; from < all.size(); ++from)
    if (next < places.size() && from == places[next]) {
      taken.push_back(all[from]);
      ++next;
    }
    else
      all[to++] = all[from];
  all.resize(to);
  return taken;
}

template <typename T>
void put_in(std::vector<T>& all, const std::vector<std::size_t>& places,
            const std::vector<T>& taken)
{
  std::size_t from = all.size(), left = taken.size();
  all.resize(from + left);
  for (std::size_t to = all.size(); left != 0;) // from the end, where there is room
    if (--to == places[left - 1])
      all[to] = taken[--left];
    else
      all[to] = all[--from];
}

} // namespace

void find_invalid_points(Point_file& file, const Read_options& options)
{
  const bool with_zeros = file.zeros_are_invalid || options.zeros_are_invalid;
  for (std::size_t i = 0; i < file.points.size(); ++i)
    if (!is_finite(file.points[i]) || (with_zeros && file.points[i] == Point_3(CGAL::ORIGIN)))
      file.invalid.push_back(i);
  if (file.invalid.empty())
    return;
  const bool is_default = options.invalid == Invalid::BY_FORMAT;
  if (options.invalid == Invalid::ERROR || (is_default && !file.defines_invalid))
    refuse(file);
  file.drops_invalid = options.invalid == Invalid::DROP;
  if (file.drops_invalid && file.invalid.size() == file.points.size())
    throw std::runtime_error("all of its points are invalid");
}

Set_aside::Set_aside(Point_file& file)
    : m_file(file), m_points(take_out(file.points, file.invalid)),
      m_normals(take_out(file.normals, file.invalid)), m_sides(take_out(file.sides, file.invalid)),
      m_scans(take_out(file.scans, file.invalid))
{}

void Set_aside::put_back()
{
  put_in(m_file.points, m_file.invalid, m_points);
  if (!m_normals.empty())
    put_in(m_file.normals, m_file.invalid, m_normals);
  if (!m_sides.empty())
    put_in(m_file.sides, m_file.invalid, m_sides);
  if (!m_scans.empty())
    put_in(m_file.scans, m_file.invalid, m_scans);
}

} // namespace point_files
