// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FITTING_ANGLE_WEIGHT_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FITTING_ANGLE_WEIGHT_H

#include <CGAL/Point_set_flow/internal/fitting/Lanes.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// How much is left at a time of the flow, 0 to 1, of a width that becomes narrower.
inline double annealing(double time, int power)
{
  const double left = 1. - .513 * time;
  return power == 2 ? left * left : left * left * left;
}

/// The weight of a neighbor by the angle between its normal and the own one: in the first step
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

  /// \param cosine the products of the two normals, whose sides do not matter
  /// \return the weight is exp(-exponent)
  Lanes exponent(const Lanes& cosine) const
  {
    const Lanes x = (1. - cosine.abs()) * m_inverse;
    return x * x;
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FITTING_ANGLE_WEIGHT_H
