// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FITTING_TANGENT_MOMENTS_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FITTING_TANGENT_MOMENTS_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/Core_kernel.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// Second moments of vectors in one plane, the tangent plane of a point
class Tangent_moments {
  double m_xx = 0., m_xy = 0., m_xz = 0., m_yy = 0., m_yz = 0., m_zz = 0.;

public:
  void add(double weight, const Vector_3& d)
  {
    const Vector_3 w = weight * d;
    m_xx += w.x() * d.x(), m_xy += w.x() * d.y(), m_xz += w.x() * d.z();
    m_yy += w.y() * d.y(), m_yz += w.y() * d.z(), m_zz += w.z() * d.z();
  }

  /// The smaller moment as a share of the larger one: 0 for vectors along a line, 1 for those of a disc, and
  /// if there are none
  double aspect() const
  {
    // of three eigenvalues, the one across the plane is 0
    const double half_trace = .5 * (m_xx + m_yy + m_zz);
    const double product =
        m_xx * m_yy - m_xy * m_xy + m_xx * m_zz - m_xz * m_xz + m_yy * m_zz - m_yz * m_yz;
    const double root = std::sqrt((std::max)(half_trace * half_trace - product, 0.));
    const double larger = half_trace + root;
    return larger > 0. ? (std::max)(half_trace - root, 0.) / larger : 1.;
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FITTING_TANGENT_MOMENTS_H
