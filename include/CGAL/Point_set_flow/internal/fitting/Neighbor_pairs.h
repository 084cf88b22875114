// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FITTING_NEIGHBOR_PAIRS_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FITTING_NEIGHBOR_PAIRS_H

#include <CGAL/Point_set_flow/Neighborhood_3.h>
#include <CGAL/Point_set_flow/internal/fitting/Lanes.h>

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// A neighborhood that is looked at two neighbors at a time. The last of an odd number has the
/// point itself beside it, at a distance of 0 and with the own normal.
class Two_by_two {
  const Neighborhood_3& m_neighborhood;

public:
  const Vector_3 normal; ///< of the point; null if it is not known

  explicit Two_by_two(const Neighborhood_3& neighborhood)
      : m_neighborhood(neighborhood),
        normal(neighborhood.has_normals() ? neighborhood.normal() : Vector_3(0., 0., 0.))
  {}

  /// how often the point itself is visited
  double pads() const { return double(m_neighborhood.size() % 2); }

  /// from the point to the neighbors `j` and `j + 1`
  Lanes_3 differences(std::size_t j) const
  {
    const Point_3& p = m_neighborhood.center();
    return Lanes_3(p, m_neighborhood[j], j + 1 < m_neighborhood.size() ? m_neighborhood[j + 1] : p);
  }

  /// of the neighbors `j` and `j + 1`
  Lanes_3 normals(std::size_t j) const
  {
    return Lanes_3(m_neighborhood.normal(j),
                   j + 1 < m_neighborhood.size() ? m_neighborhood.normal(j + 1) : normal);
  }

  /// The mean of the heights along both normals. On a sphere these differ in sign only.
  /// \param own, other along the own normal and along that of the neighbor
  /// \param cosine of the two, which may have different sides
  static Lanes mean_height(const Lanes& own, const Lanes& other, const Lanes& cosine)
  {
    const Lanes side(std::copysign(.5, cosine[0]), std::copysign(.5, cosine[1]));
    return .5 * own + side * other;
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FITTING_NEIGHBOR_PAIRS_H
