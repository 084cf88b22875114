// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FITTING_NEIGHBOR_PAIRS_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FITTING_NEIGHBOR_PAIRS_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/Neighborhood_3.h>

#include <Eigen/Core>

#include <boost/config.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// One number for each of two neighbors, computed at once: one register on any x86-64 or ARM processor.
typedef Eigen::Array2d Lanes;

/// Vectors of two neighbors
struct Lanes_3 {
  Lanes x, y, z;

  Lanes_3(const Vector_3& a, const Vector_3& b) : x(a.x(), b.x()), y(a.y(), b.y()), z(a.z(), b.z())
  {}
  /// from one point to two
  Lanes_3(const Point_3& from, const Point_3& a, const Point_3& b)
      : x(Lanes(a.x(), b.x()) - from.x()), y(Lanes(a.y(), b.y()) - from.y()),
        z(Lanes(a.z(), b.z()) - from.z())
  {}

  Lanes operator*(const Vector_3& v) const { return x * v.x() + y * v.y() + z * v.z(); }
  Lanes operator*(const Lanes_3& v) const { return x * v.x + y * v.y + z * v.z; }
  Lanes squared_length() const { return *this * *this; }
};

/// The neighbors of a point, two at a time. The last of an odd number is paired with the point
/// itself, at a distance of 0 and with its own normal.
class Neighbor_pairs {
  const Neighborhood_3& m_neighborhood;

public:
  const Vector_3 normal; ///< of the point; null if it is not known

  explicit Neighbor_pairs(const Neighborhood_3& neighborhood)
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
};

/// A weight from its exponent: \f$(1 - x/32)^{32}\f$, and 0 from 32 on. It is close to
/// \f$e^{-x}\f$, at a tenth of the cost.
BOOST_FORCEINLINE Lanes bell(const Lanes& x) // or registers would pass through memory
{
  Lanes b = (1. - x * (1. / 32.)).max(0.);
  b *= b;
  b *= b;
  b *= b;
  b *= b;
  return b * b;
}

/// The factor by which a width has narrowed at a time of the flow, 0 to 1.
inline double annealing(double time, int power)
{
  const double left = 1. - .513 * time;
  return power == 2 ? left * left : left * left * left;
}

/// The weight of a neighbor by the angle between its normal and that of the point: in the first step
/// wide enough for what the noise does to normals, in the last as narrow as features need it.
class Angle_weight {
  double m_inverse;

public:
  /// \param noise in multiples of the spacing
  /// \param time 0 in the first step of the flow, 1 in the last
  Angle_weight(double noise, double time)
  {
    // sines of half of the angles: up to 120 degrees at first, 10 in the end
    const double first = (std::min)(.64 * std::sqrt(noise), .866), last = .0872;
    const double sine = (std::max)(first * annealing(time, 3), last);
    m_inverse = 1. / (2. * sine * sine); // 1 - cos
  }

  /// \param cosine the products of the two normals, whose orientation is arbitrary
  /// \return the weight is `bell(exponent)`
  Lanes exponent(const Lanes& cosine) const
  {
    const Lanes x = (1. - cosine.abs()) * m_inverse;
    return x * x;
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FITTING_NEIGHBOR_PAIRS_H
