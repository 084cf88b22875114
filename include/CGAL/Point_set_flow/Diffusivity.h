// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_DIFFUSIVITY_H
#define CGAL_POINT_SET_FLOW_DIFFUSIVITY_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Point_set_flow {

/// \ingroup PkgPointSetFlowFlows
/// \f$g(x) = 1 / (1 + K x^2)\f$, section 2.3 of the paper: 1 on flat parts, falling towards 0 at
/// features, and 1/2 where the surface variation is \f$1/\sqrt K\f$.
class Diffusivity {
  double m_feature_threshold;

public:
  /// \param feature_threshold the constant \f$K \ge 0\f$, without unit
  explicit Diffusivity(double feature_threshold) : m_feature_threshold(feature_threshold) {}

  /// \f$g\f$ at a surface variation
  double operator()(double variation) const
  {
    return 1. / (1. + m_feature_threshold * variation * variation);
  }

  /// \f$K\f$
  double feature_threshold() const { return m_feature_threshold; }

  /// the diffusivity that is 1/2 at the given surface variation, or at 1e-150 if that is larger
  static Diffusivity half_at(double variation)
  {
    variation = (std::max)(variation, 1e-150);
    return Diffusivity(1. / (variation * variation));
  }
};

/// \ingroup PkgPointSetFlowFlows
/// The surface variation, equation (2), in the middle of a straight crease between two planes whose
/// normals differ by `angle` degrees, for points spread evenly over a disc.
///
/// Half a disc of radius 1 has the moments \f$E[s^2] = 1/4\f$ and \f$E[s] = 4/(3\pi)\f$ across the
/// crease; folding both halves down by half the angle gives the three eigenvalues.
inline double crease_variation(double angle)
{
  const double sine = std::sin(angle * CGAL_PI / 360.), sine2 = sine * sine;
  const double mean = 4. / (3. * CGAL_PI);
  const double across = (1. - sine2) / 4., height = sine2 * (.25 - mean * mean);
  return height / (.25 + across + height);
}

} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_DIFFUSIVITY_H
