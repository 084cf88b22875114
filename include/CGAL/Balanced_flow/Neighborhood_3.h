// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BALANCED_FLOW_NEIGHBORHOOD_3_H
#define CGAL_BALANCED_FLOW_NEIGHBORHOOD_3_H

#include <CGAL/Balanced_flow/Vector_types.h>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Point_set_flow {

/// \ingroup PkgBalancedFlowRef
/// A point with its nearest neighbours, as a curvature estimator sees it: a view on the arrays of
/// the core, cheap to make and to copy.
///
/// The coordinates are those of the data moved to the origin, so that differences between points
/// keep their digits far from the origin.
class Neighborhood_3 {
  const Point_3* m_points;
  const std::uint32_t* m_neighbors;
  std::size_t m_size, m_center;
  double m_radius, m_filter_width;

public:
  /// \param points the points of the surface
  /// \param center the index of the point in the middle
  /// \param neighbors, size the indices of its neighbours, nearest first, without itself
  /// \param radius the neighbourhood radius: the distance of the farthest neighbour
  /// \param filter_width \f$\sigma\f$ of \f$G\f$ in multiples of the radius
  Neighborhood_3(const Point_3* points, std::size_t center, const std::uint32_t* neighbors,
                 std::size_t size, double radius, double filter_width)
      : m_points(points), m_neighbors(neighbors), m_size(size), m_center(center), m_radius(radius),
        m_filter_width(filter_width)
  {}

  const Point_3& center() const { return m_points[m_center]; }
  /// the number of neighbours, the point itself not counted
  std::size_t size() const { return m_size; }
  const Point_3& operator[](std::size_t j) const { return m_points[m_neighbors[j]]; }
  double radius() const { return m_radius; }

  /// \f$G(x) = e^{-x^2 / 2\sigma^2}\f$ of Eq. (3)
  double gaussian(double squared_distance) const
  {
    const double sigma = m_filter_width * m_radius, divisor = 2. * sigma * sigma;
    // a width of 0, or a neighbourhood shrunk to a point, leaves the point alone
    return divisor > 0. ? std::exp(-squared_distance / divisor) : (squared_distance > 0. ? 0. : 1.);
  }
};

} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_BALANCED_FLOW_NEIGHBORHOOD_3_H
