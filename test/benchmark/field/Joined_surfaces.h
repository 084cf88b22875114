// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_BENCHMARK_JOINED_SURFACES_H
#define POINT_SET_FLOW_BENCHMARK_JOINED_SURFACES_H

#include "measure/Surface.h"

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace comparison {

class Plane_surface : public Surface {
  Point_3 m_point;
  Vector_3 m_normal;

public:
  /// \param normal a unit vector
  Plane_surface(const Point_3& point, const Vector_3& normal) : m_point(point), m_normal(normal) {}
  Surface_point closest(const Point_3& p) const override
  {
    const double distance = (p - m_point) * m_normal;
    return {p - distance * m_normal, m_normal, distance};
  }
};

class Sphere_surface : public Surface {
  Point_3 m_center;
  double m_radius;

public:
  Sphere_surface(const Point_3& center, double radius) : m_center(center), m_radius(radius) {}
  Surface_point closest(const Point_3& p) const override
  {
    const double length = std::sqrt(CGAL::squared_distance(p, m_center));
    const Vector_3 normal = (p - m_center) / length;
    return {m_center + m_radius * normal, normal, length - m_radius};
  }
};

/// Several surfaces as one: what is closest is that of the closest of them.
class Joined_surfaces : public Surface {
  std::vector<std::unique_ptr<const Surface>> m_parts;

public:
  void add(std::unique_ptr<const Surface> part) { m_parts.push_back(std::move(part)); }
  Surface_point closest(const Point_3& p) const override
  {
    Surface_point best = m_parts.front()->closest(p);
    for (std::size_t i = 1; i < m_parts.size(); ++i) {
      const Surface_point found = m_parts[i]->closest(p);
      if (std::abs(found.signed_distance) < std::abs(best.signed_distance))
        best = found;
    }
    return best;
  }
};

} // namespace comparison

#endif // POINT_SET_FLOW_BENCHMARK_JOINED_SURFACES_H
