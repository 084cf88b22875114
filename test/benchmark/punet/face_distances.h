// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_BENCHMARK_FACE_DISTANCES_H
#define POINT_SET_FLOW_BENCHMARK_FACE_DISTANCES_H

#include "measure/Mesh_surface.h"
#include "measure/Nearest_points.h"
#include "measure/Smoothers.h"

#include <CGAL/for_each.h>

namespace comparison {

/// The exact squared distance from a triangle to the nearest of some points. A nearest point of the
/// middle of a triangle need not be a nearest one of the triangle: parts of it are searched as long
/// as one of their points may be nearer than what was found.
class Face_distance {
  typedef std::array<Point_3, 3> Corners;
  const Points& m_points;
  const Nearest_points& m_nearest;
  Kernel::Triangle_3 m_triangle;
  double m_best = std::numeric_limits<double>::infinity();

  void try_point(std::size_t i)
  {
    m_best = (std::min)(m_best, CGAL::squared_distance(m_points[i], m_triangle));
  }

  void search(const Corners& c)
  {
    const Point_3 middle = CGAL::centroid(c[0], c[1], c[2]);
    double radius = 0.;
    for (const Point_3& corner : c)
      radius = (std::max)(radius, std::sqrt(CGAL::squared_distance(middle, corner)));
    const auto nearest = m_nearest(middle);
    try_point(nearest.first);
    if (std::sqrt(nearest.second) - radius >= std::sqrt(m_best))
      return;
    // few points are nearer to the middle than this, or else the parts have fewer
    const unsigned int few = 16;
    const auto neighbors = m_nearest(middle, few);
    for (const auto& neighbor : neighbors)
      try_point(neighbor.first);
    if (neighbors.size() < few || std::sqrt(neighbors.back().second) >= radius + std::sqrt(m_best))
      return;
    const Point_3 m[3] = {CGAL::midpoint(c[1], c[2]), CGAL::midpoint(c[2], c[0]),
                          CGAL::midpoint(c[0], c[1])};
    for (const Corners& part : {Corners{m[0], m[1], m[2]}, Corners{c[0], m[2], m[1]},
                                Corners{m[2], c[1], m[0]}, Corners{m[1], m[0], c[2]}})
      search(part);
  }

public:
  Face_distance(const Points& points, const Nearest_points& nearest, const Corners& corners)
      : m_points(points), m_nearest(nearest), m_triangle(corners[0], corners[1], corners[2])
  {
    search(corners);
  }
  double squared() const { return m_best; }
};

/// The mean, over the faces, of the squared distance to the nearest point
inline double mean_squared_face_distance(const Mesh_surface& surface, const Points& points)
{
  const Nearest_points nearest(points);
  const std::size_t n = surface.mesh().number_of_faces();
  std::vector<double> squares(n);
  CGAL::for_each<Concurrency_tag>(numbers(n), [&](const std::size_t& i) {
    const auto corners = surface.triangle(Mesh::Face_index(Mesh::size_type(i)));
    squares[i] = Face_distance(points, nearest, corners).squared();
    return true;
  });
  double sum = 0.;
  for (const double square : squares)
    sum += square;
  return sum / double(n);
}

} // namespace comparison

#endif // POINT_SET_FLOW_BENCHMARK_FACE_DISTANCES_H
