// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BALANCED_FLOW_INTERNAL_ANGLE_WEIGHT_H
#define CGAL_BALANCED_FLOW_INTERNAL_ANGLE_WEIGHT_H

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// The weight of a neighbour by the angle between its normal and the own one: in the first step
/// wide enough for what the noise does to normals, in the last as narrow as features need it.
class Angle_weight {
  double m_inverse;

public:
  /// \param noise in multiples of the spacing
  /// \param time 0 in the first step of the flow, 1 in the last
  Angle_weight(double noise, double time)
  {
    const double first = (std::min)(80. * std::sqrt(noise), 120.), last = 10.; // degrees
    const double degrees = first > last ? first * std::pow(last / first, time) : last;
    m_inverse = 1. / (1. - std::cos(degrees * CGAL_PI / 180.));
  }

  /// \param cosine the product of the two normals, whose sides do not matter
  /// \return the weight is exp(-exponent)
  double exponent(double cosine) const
  {
    const double x = (1. - std::abs(cosine)) * m_inverse;
    return x * x;
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_BALANCED_FLOW_INTERNAL_ANGLE_WEIGHT_H
