// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FITTING_SCAN_EVIDENCE_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FITTING_SCAN_EVIDENCE_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/fitting/Covariance_3.h>
#include <CGAL/Point_set_flow/internal/parallel/Array.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// Sums over points of the products of their coordinates about means: two in the tangent plane, and the
/// height above it
class Height_regression {
  double m_xx = 0., m_xy = 0., m_yy = 0., m_xh = 0., m_yh = 0., m_hh = 0.;

public:
  /// \param first, last points, whose mean is taken off
  template <typename Iterator>
  void add(Iterator first, Iterator last)
  {
    Vector_3 mean(0., 0., 0.);
    for (Iterator it = first; it != last; ++it)
      mean = mean + it->second;
    mean = mean / double(last - first);
    for (Iterator it = first; it != last; ++it) {
      const Vector_3 d = it->second - mean;
      m_xx += d.x() * d.x(), m_xy += d.x() * d.y(), m_yy += d.y() * d.y();
      m_xh += d.x() * d.z(), m_yh += d.y() * d.z(), m_hh += d.z() * d.z();
    }
  }

  /// The sum of the squares of the heights that is left if the plane is tilted to where it fits best
  double rest() const
  {
    const double trace = m_xx + m_yy, det = m_xx * m_yy - m_xy * m_xy;
    if (!(det > 1e-12 * trace * trace)) // on a line
      return m_hh;
    const double tilted = (m_yy * m_xh * m_xh - 2. * m_xy * m_xh * m_yh + m_xx * m_yh * m_yh) / det;
    return (std::max)(m_hh - tilted, 0.);
  }
};

/// The part of the deviation of a neighborhood that is registration error.
struct Scan_evidence {
  /// of the heights above a plane, what the scans explain; without bias, hence also negative
  double variance = 0.;
  double share = 0.; ///< of it in the whole variance, 0 to 1
};

/// How much of the variance of the heights above a plane the scans of the points explain. The share is eta
/// squared, with the degrees of freedom of plane and scans taken off. Nothing, if there is one scan only, or too
/// few points to tell.
/// \param neighbors, size those of point `i`
/// \param scans the number of the scan of each point
inline Scan_evidence scan_evidence(const Array<Point_3>& points, std::size_t i,
                                   const std::uint32_t* neighbors, std::size_t size,
                                   const Array<std::uint32_t>& scans)
{
  const Neighborhood_3 neighborhood(points.data(), i, neighbors, size, 0., 0.);
  const Vector_3 normal = smallest_eigenpair(Covariance_3(neighborhood)).vector;
  const Vector_3 axis = std::abs(normal.x()) < .6 ? Vector_3(1., 0., 0.) : Vector_3(0., 1., 0.);
  const Vector_3 e1 = cross_product(normal, axis), e2 = cross_product(normal, e1);
  typedef std::pair<std::uint32_t, Vector_3>
      Scanned; // the number of the scan, and where in the plane
  std::vector<Scanned> scanned;
  scanned.reserve(size + 1);
  const auto add = [&](std::size_t j) {
    const Vector_3 d = points[j] - points[i];
    scanned.emplace_back(scans[j], Vector_3(d * e1, d * e2, d * normal));
  };
  add(i);
  for (std::size_t j = 0; j < size; ++j)
    add(neighbors[j]);
  std::sort(scanned.begin(), scanned.end(),
            [](const Scanned& a, const Scanned& b) { return a.first < b.first; });

  // One plane for all points, and parallel ones, each at the height of a scan
  Height_regression together, within;
  together.add(scanned.begin(), scanned.end());
  double number_of_scans = 0.;
  for (auto first = scanned.begin(); first != scanned.end(); number_of_scans += 1.) {
    const auto last = std::find_if(first, scanned.end(),
                                   [&](const Scanned& s) { return s.first != first->first; });
    within.add(first, last);
    first = last;
  }
  const double of_plane = 3., freedom = double(scanned.size()) - of_plane;
  const double freedom_within = freedom - (number_of_scans - 1.), rest = together.rest();
  if (number_of_scans < 2. || !(freedom_within > 0.) || !(rest > 0.))
    return {};
  const double variance = rest / freedom - within.rest() / freedom_within;
  return {variance, (std::min)((std::max)(variance / (rest / freedom), 0.), 1.)};
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FITTING_SCAN_EVIDENCE_H
