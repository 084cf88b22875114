// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_BENCHMARK_FITTED_SURFACE_H
#define POINT_SET_FLOW_BENCHMARK_FITTED_SURFACE_H

#include "measure/Nearest_points.h"
#include "measure/Smoothers.h"

namespace comparison {

/// A denser cloud as the true surface: the plane through the middle of the twelve nearest points, with
/// the PCA normal of the nearest of them, so that the noise of single points counts less. Its sides
/// are not known, and distances are meaningful near the cloud only.
class Fitted_surface : public Surface {
  static constexpr unsigned int k = 12;
  Points m_points;
  Vectors m_normals;
  Nearest_points m_nearest;

public:
  explicit Fitted_surface(const Points& points)
      : m_points(points),
        m_normals(normals_in_order(with_normals<Concurrency_tag>(points, false, k))),
        m_nearest(m_points)
  {}

  Surface_point closest(const Point_3& p) const override
  {
    const auto neighbors = m_nearest(p, k);
    Vector_3 to_middle = CGAL::NULL_VECTOR;
    for (const auto& neighbor : neighbors)
      to_middle += (m_points[neighbor.first] - p) / double(neighbors.size());
    const Vector_3& normal = m_normals[neighbors.front().first];
    const double distance = -(to_middle * normal);
    return {p - distance * normal, normal, distance};
  }
};

} // namespace comparison

#endif // POINT_SET_FLOW_BENCHMARK_FITTED_SURFACE_H
