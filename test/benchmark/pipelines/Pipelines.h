// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_BENCHMARK_PIPELINES_H
#define POINT_SET_FLOW_BENCHMARK_PIPELINES_H

#include "measure/Mesh_surface.h"

#include <optional>

namespace comparison {

/// CGAL's reconstructions, each from points to a mesh, and its detection of planes. One file for
/// each, because CGAL takes the compiler much memory.

/// Without a mesh where the reconstruction fails
typedef std::optional<Mesh> Reconstructed;

Reconstructed advancing_front(const Points& points);

/// With normals, PCA's of 18 neighbors if none are given. They point to the side of `sides`, or, if
/// there are none, to sides that are made consistent along a spanning tree.
Reconstructed poisson(const Points& points, const Vectors& normals, const Vectors& sides);

enum class Scale_smoother { none, weighted_pca, jet, point_set_flow };

/// With CGAL's default mesher, alpha shapes, of a radius that CGAL estimates from the points. The
/// smoothers of CGAL are applied four times as in its examples, ours once.
Reconstructed scale_space(const Points& points, Scale_smoother smoother);

/// What is measured of the planes that are found in smoothed points
struct Plane_measures {
  double planes = 0.;
  double share = 0.;    ///< of the points that lie in a plane
  double residual = 0.; ///< rms distance of these from their planes
  double of_scan = 0.;  ///< the same for the points of the scan that they were
};

/// Planes by CGAL's efficient RANSAC, which is random: the mean of some runs. PCA's normals if
/// there are none.
Plane_measures measure_planes(const Points& scan, const Points& smoothed, const Vectors& normals,
                              double epsilon, unsigned int runs);

} // namespace comparison

#endif // POINT_SET_FLOW_BENCHMARK_PIPELINES_H
