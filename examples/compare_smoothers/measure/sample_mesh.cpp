// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <queue>
#include <random>
#include <utility>
#include <vector>

namespace comparison {

namespace {

/// Cells of a grid with the numbers of the points in them.
class Point_grid {
  typedef std::array<long, 3> Cell;
  double m_width;
  std::map<Cell, std::vector<std::size_t>> m_cells;

  Cell cell(const Point_3& p) const
  {
    return {std::lround(p.x() / m_width), std::lround(p.y() / m_width),
            std::lround(p.z() / m_width)};
  }

public:
  Point_grid(const Points& points, double width) : m_width(width)
  {
    for (std::size_t i = 0; i < points.size(); ++i)
      m_cells[cell(points[i])].push_back(i);
  }

  /// Calls `visit` with all points closer than the width of a cell, and some others
  template <typename Visit>
  void for_each_near(const Point_3& p, const Visit& visit) const
  {
    const Cell center = cell(p);
    for (long x = -1; x <= 1; ++x)
      for (long y = -1; y <= 1; ++y)
        for (long z = -1; z <= 1; ++z) {
          const auto found = m_cells.find({center[0] + x, center[1] + y, center[2] + z});
          if (found != m_cells.end())
            for (const std::size_t i : found->second)
              visit(i);
        }
  }
};

struct Candidates {
  Samples samples;
  std::vector<double> widths; // the distance that the samples would have, if packed best
};

/// Five times as many random points on the mesh as are wanted, n
Candidates draw_candidates(const Mesh_surface& surface, std::size_t n, unsigned int seed,
                           const std::function<double(const Point_3&)>& density)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0., 1.);
  std::discrete_distribution<unsigned int> random_face(surface.face_areas().begin(),
                                                       surface.face_areas().end());
  Candidates found;
  std::size_t tries = 0;
  while (found.samples.points.size() < 5 * n) {
    const Mesh::Face_index f(random_face(random));
    const std::array<Point_3, 3> corners = surface.triangle(f);
    double a = unit(random), b = unit(random);
    if (a + b > 1.)
      a = 1. - a, b = 1. - b;
    const Point_3 p = corners[0] + a * (corners[1] - corners[0]) + b * (corners[2] - corners[0]);
    const double share = density(p);
    ++tries;
    if (unit(random) > share)
      continue;
    found.samples.points.push_back(p);
    found.samples.normals.push_back(surface.normal(f));
    found.widths.push_back(1. / std::sqrt(share));
  }
  const double area = surface.area() * double(found.samples.points.size()) / double(tries);
  const double width = 2. * std::sqrt(area / (2. * std::sqrt(3.) * double(n)));
  for (double& w : found.widths)
    w *= width;
  return found;
}

/// Takes out candidates until n are left.
/// \return whether each one is taken out
std::vector<char> eliminate(const Candidates& found, std::size_t n)
{
  const Samples& candidates = found.samples;
  const std::vector<double>& widths = found.widths;
  const Point_grid grid(candidates.points, *std::max_element(widths.begin(), widths.end()));
  const auto closeness = [&](std::size_t i, std::size_t j) {
    if (candidates.normals[i] * candidates.normals[j] < -.5)
      return 0.; // the other side of a thin part
    const double d = std::sqrt(CGAL::squared_distance(candidates.points[i], candidates.points[j]));
    const double w = (std::min)(widths[i], widths[j]);
    return std::pow((std::max)(0., 1. - d / w), 8);
  };
  std::vector<double> crowding(candidates.points.size(), 0.);
  std::priority_queue<std::pair<double, std::size_t>> most_crowded;
  for (std::size_t i = 0; i < crowding.size(); ++i) {
    grid.for_each_near(candidates.points[i], [&](std::size_t j) {
      if (j != i)
        crowding[i] += closeness(i, j);
    });
    most_crowded.emplace(crowding[i], i);
  }
  std::vector<char> removed(crowding.size(), false);
  for (std::size_t left = crowding.size(); left > n;) {
    const auto [value, i] = most_crowded.top();
    most_crowded.pop();
    if (value != crowding[i]) { // it only falls: put back where it belongs now
      most_crowded.emplace(crowding[i], i);
      continue;
    }
    removed[i] = true;
    --left;
    const std::size_t gone = i;
    grid.for_each_near(candidates.points[gone], [&](std::size_t j) {
      if (!removed[j])
        crowding[j] -= closeness(gone, j);
    });
  }
  return removed;
}

} // namespace

Samples sample_mesh(const Mesh_surface& surface, std::size_t n, unsigned int seed,
                    const std::function<double(const Point_3&)>& density)
{
  const Candidates found = draw_candidates(surface, n, seed, density);
  const std::vector<char> removed = eliminate(found, n);
  Samples samples; // the candidates are in random order already
  for (std::size_t i = 0; i < removed.size(); ++i)
    if (!removed[i]) {
      samples.points.push_back(found.samples.points[i]);
      samples.normals.push_back(found.samples.normals[i]);
    }
  return samples;
}

} // namespace comparison
