// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FITTING_NEIGHBOR_LANES_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FITTING_NEIGHBOR_LANES_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/Neighborhood_3.h>
#include <CGAL/Point_set_flow/internal/fitting/Lane_vectors.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// The neighbors of a point, as many at a time as there are lanes, with lengths in neighborhood radii. The last are filled up with the
/// point itself, at a distance of 0 and with its own normal.
class Neighbor_lanes {
  const Neighborhood_3& m_neighborhood;
  const double m_scale;

public:
  static constexpr std::size_t width = lane_width;
  const Lanes_3 normal; ///< of the point; null if it is not known

  explicit Neighbor_lanes(const Neighborhood_3& neighborhood)
      : m_neighborhood(neighborhood),
        m_scale(neighborhood.radius() > 0. ? 1. / neighborhood.radius() : 0.),
        normal(
            same_lanes(neighborhood.has_normals() ? neighborhood.normal() : Vector_3(NULL_VECTOR)))
  {}

  /// how often the point itself is visited
  double pads() const { return double((width - m_neighborhood.size() % width) % width); }

  /// of the neighbors from `j` on
  BOOST_FORCEINLINE Lane_numbers numbers(std::size_t j) const
  {
    const Neighbor_numbers& all = m_neighborhood.numbers();
    const std::size_t left = all.size() - j;
    if (left >= width)
      return lane_numbers([&](std::size_t l) -> std::size_t { return all[j + l]; });
    const std::size_t point = m_neighborhood.center_number();
    return lane_numbers([&](std::size_t l) { return l < left ? all[j + l] : point; });
  }

  /// from the point to others
  BOOST_FORCEINLINE Lanes_3 differences(const Lane_numbers& to) const
  {
    return internal::differences(m_neighborhood.points(), m_neighborhood.center(), to, m_scale);
  }

  BOOST_FORCEINLINE Lanes_3 normals(const Lane_numbers& of) const
  {
    return vectors(m_neighborhood.normals(), of);
  }
};

/// The factor by which a width has narrowed at a time of the flow, 0 to 1.
inline double annealing(double time, int power)
{
  const double left = 1. - .513 * time, squared = left * left;
  return power == 2 ? squared : squared * squared * squared;
}

/// The weight of a neighbor by the angle between its normal and that of the point: in the first step
/// wide enough for what the noise does to normals, in the last as narrow as features need it.
class Angle_weight {
  float m_inverse;

public:
  /// \param noise in multiples of the spacing
  /// \param time 0 in the first step of the flow, 1 in the last
  Angle_weight(double noise, double time)
  {
    // squared sines of half of the angles: up to 120 degrees at first, 10 in the end
    const double first = (std::min)(.64 * .64 * noise, .866 * .866), last = .0872 * .0872;
    const double squared_sine = (std::max)(first * annealing(time, 6), last);
    m_inverse = float(1. / (2. * squared_sine)); // 1 - cos
  }

  /// \param cosine the products of the two normals, whose orientation is arbitrary
  /// \return the weight is `bell(exponent)`
  BOOST_FORCEINLINE Lanes exponent(const Lanes& cosine) const
  {
    const Lanes x = (1.f - cosine.abs()) * m_inverse;
    return x * x;
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FITTING_NEIGHBOR_LANES_H
