// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef COMPARISON_POINT_SURFACE_H
#define COMPARISON_POINT_SURFACE_H

#include "Nearest_points.h"
#include "Numbered_points.h"

namespace comparison {

/// Clean points as the true surface: the plane of the nearest one, with its PCA normal (k=18, MST
/// orientation). Sharp edges are not known.
class Point_surface : public Surface {
  Points m_points;
  Vectors m_normals;
  Nearest_points m_nearest;

public:
  explicit Point_surface(const Points& points)
      : m_points(points),
        m_normals(normals_in_order(with_normals<CGAL::Sequential_tag>(points, true))),
        m_nearest(m_points)
  {}

  Surface_point closest(const Point_3& p) const override
  {
    const std::size_t i = m_nearest(p).first;
    const double distance = (p - m_points[i]) * m_normals[i];
    return {p - distance * m_normals[i], m_normals[i], distance};
  }

  const Vectors& normals() const { return m_normals; }
};

} // namespace comparison

#endif // COMPARISON_POINT_SURFACE_H
