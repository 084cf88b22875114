// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_BENCHMARK_BUILDING_FRONT_H
#define POINT_SET_FLOW_BENCHMARK_BUILDING_FRONT_H

#include "measure/read_mesh.h"

#include <CGAL/number_utils.h>

#include <random>

namespace comparison {

/// The front of a building: heights over a grid of lines, with upright sides between them.
class Front_maker {
  std::vector<double> m_x, m_z;              // the lines
  std::vector<std::vector<double>> m_height; // of the cells between them, towards -y
  Points m_points;
  Polygons m_faces;

  void add_face(const Point_3& a, const Point_3& b, const Point_3& c, const Point_3& d)
  {
    const std::size_t first = m_points.size();
    m_points.insert(m_points.end(), {a, b, c, d});
    m_faces.push_back({first, first + 1, first + 2, first + 3});
  }
  Point_3 corner(std::size_t i, std::size_t j, double height) const
  {
    return {m_x[i], -height, m_z[j]};
  }

public:
  Front_maker(std::vector<double> x, std::vector<double> z)
      : m_x(std::move(x)), m_z(std::move(z)),
        m_height(m_x.size() - 1, std::vector<double>(m_z.size() - 1, 0.))
  {}
  /// Raises the cells from line i0 to i1 and from j0 to j1
  void raise(std::size_t i0, std::size_t i1, std::size_t j0, std::size_t j1, double height)
  {
    for (std::size_t i = i0; i < i1; ++i)
      for (std::size_t j = j0; j < j1; ++j)
        m_height[i][j] = height;
  }

  std::optional<Mesh> mesh()
  {
    for (std::size_t i = 0; i + 1 < m_x.size(); ++i)
      for (std::size_t j = 0; j + 1 < m_z.size(); ++j) {
        const double h = m_height[i][j];
        add_face(corner(i, j, h), corner(i + 1, j, h), corner(i + 1, j + 1, h),
                 corner(i, j + 1, h));
        if (i > 0 && m_height[i - 1][j] != h)
          add_face(corner(i, j, m_height[i - 1][j]), corner(i, j, h), corner(i, j + 1, h),
                   corner(i, j + 1, m_height[i - 1][j]));
        if (j > 0 && m_height[i][j - 1] != h)
          add_face(corner(i, j, m_height[i][j - 1]), corner(i + 1, j, m_height[i][j - 1]),
                   corner(i + 1, j, h), corner(i, j, h));
      }
    return make_mesh(m_points, m_faces);
  }
};

/// A front with axes of windows in two floors and pilasters between them, of radius 1 or a little
/// less around the origin. The reliefs of the pilasters and the frames are half a spacing to three
/// spacings; panes lie two behind the wall.
inline std::optional<Mesh> building_front(double spacing, unsigned int seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0., 1.);
  const auto relief = [&]() { return spacing * .5 * std::pow(6., unit(random)); };
  const unsigned int axes = 3, floors = 2;
  const double width = 1.6, height = 1.1;
  // each axis: pilaster, wall, frame, pane, frame, wall; each floor: wall, frame, pane, frame
  std::vector<double> x, z;
  for (unsigned int i = 0; i < axes; ++i)
    for (const double part : {0., .15, .3, .38, .77, .85})
      x.push_back(width * ((i + part) / axes - .5));
  x.push_back(width * .5);
  for (unsigned int j = 0; j < floors; ++j)
    for (const double part : {0., .22, .3, .82})
      z.push_back(height * ((j + part) / floors - .5));
  z.insert(z.end(), {height * (.5 - .05), height * .5});
  Front_maker front(x, z);
  for (unsigned int i = 0; i < axes; ++i) {
    for (unsigned int j = 0; j < floors; ++j) {
      front.raise(6 * i + 2, 6 * i + 5, 4 * j + 1, 4 * j + 4, relief());
      front.raise(6 * i + 3, 6 * i + 4, 4 * j + 2, 4 * j + 3, -2. * spacing);
    }
    front.raise(6 * i, 6 * i + 1, 0, z.size() - 1, relief());
  }
  front.raise(0, x.size() - 1, z.size() - 2, z.size() - 1, 3. * spacing); // the cornice
  return front.mesh();
}

} // namespace comparison

#endif // POINT_SET_FLOW_BENCHMARK_BUILDING_FRONT_H
