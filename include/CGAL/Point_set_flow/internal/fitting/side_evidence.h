// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FITTING_SIDE_EVIDENCE_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FITTING_SIDE_EVIDENCE_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/fitting/Covariance_3.h>
#include <CGAL/Point_set_flow/internal/fitting/Mean_and_squares.h>
#include <CGAL/Point_set_flow/internal/parallel/Array.h>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// What a neighborhood tells on whether the given sides can be trusted.
struct Side_evidence {
  bool is_known = false; ///< whether the point itself has a side
  std::size_t known = 0; ///< how many of the points have one
  /// 0 if all are on the same side, 1 if as many are on the one side as on the other: four times the product of
  /// their shares, about 1 if sides are random
  double mixture = 0.;
  /// The t statistic of two samples for the difference between the heights of those with their side
  /// up and of those with their side down; 0 if there is none or too few to tell. The normals of a thin
  /// wall point away from each other if it is greater than 0. Random sides have a mean square of about 1.
  double t = 0.;
};

/// Tests whether given sides that differ belong to two sheets, one above the other: random
/// orientations do not tell anything on the heights.
/// \param neighbors, size those of point `i`
/// \param sides one for each point, null vectors where not known
inline Side_evidence side_evidence(const Array<Point_3>& points, std::size_t i,
                                   const std::uint32_t* neighbors, std::size_t size,
                                   const Array<Vector_3>& sides)
{
  Side_evidence evidence;
  const Neighborhood_3 neighborhood(points.data(), i, neighbors, size, 0., 0.);
  const Vector_3 normal = smallest_eigenpair(Covariance_3(neighborhood)).vector;
  Mean_and_squares up, down;
  // A vector along the surface, such as a constant one in place of normals, does not tell the side.
  const double least_cosine = .2;
  const auto add = [&](std::size_t j) {
    const double cosine = sides[j] * normal;
    if (std::abs(cosine) > least_cosine)
      (cosine > 0. ? up : down).add((points[j] - points[i]) * normal);
  };
  add(i);
  evidence.is_known = up.count + down.count > 0.;
  for (std::size_t j = 0; j < size; ++j)
    add(neighbors[j]);

  const double count = up.count + down.count;
  evidence.known = static_cast<std::size_t>(count);
  if (up.count == 0. || down.count == 0.)
    return evidence;
  evidence.mixture = 4. * up.count * down.count / (count * count);
  if (count > 2.) {
    const double variance = (up.squares + down.squares) / (count - 2.);
    const double difference = up.mean - down.mean;
    if (difference != 0.) // infinite without noise
      evidence.t = difference / std::sqrt(variance * (1. / up.count + 1. / down.count));
  }
  return evidence;
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FITTING_SIDE_EVIDENCE_H
