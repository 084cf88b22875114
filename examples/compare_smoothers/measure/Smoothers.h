// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef COMPARISON_SMOOTHERS_H
#define COMPARISON_SMOOTHERS_H

#include "Numbered_points.h"

#include <CGAL/Point_set_flow/flows.h>

#include <algorithm>
#include <cmath>

namespace comparison {

/// The smoothers that are compared, each from points to points.

typedef CGAL::Parallel_if_available_tag Concurrency_tag;

struct Smoothed {
  Points points;
  Vectors normals;         ///< if the smoother has any to give
  bool same_points = true; ///< whether point i was point i before
};

inline bool all_finite(const Points& points)
{
  return std::all_of(points.begin(), points.end(), [](const Point_3& p) {
    return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
  });
}

Smoothed jet(const Points& noisy, unsigned int k, int times = 1);

/// With a sharpness angle of 25 degrees, of points with oriented normals.
Smoothed bilateral(Numbered_points points, unsigned int k, int times = 1);

/// With the normals that it needs: PCA's with 18 neighbors.
Smoothed bilateral(const Points& noisy, unsigned int k, int times = 1);

/// Keeps as many points as there were, but they are others.
Smoothed wlop(Points noisy);

/// Numbers 0 to n-1, which the maps take as points
std::vector<std::size_t> numbers(std::size_t n);

/// A flow as the paper has it, by covariance analysis. For all flows of this package.
template <typename Flow>
Smoothed paper_flow(const Points& noisy, const Flow& flow);

/// This package with its defaults.
Smoothed point_set_flow(const Points& noisy);

/// This package with its defaults, and steps of relaxation along the surface.
Smoothed point_set_flow_relaxed(const Points& noisy, unsigned int steps);

/// This package with a neighborhood size.
Smoothed point_set_flow(const Points& noisy, unsigned int k);

} // namespace comparison

#endif // COMPARISON_SMOOTHERS_H
