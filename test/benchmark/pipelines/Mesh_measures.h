// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_BENCHMARK_MESH_MEASURES_H
#define POINT_SET_FLOW_BENCHMARK_MESH_MEASURES_H

#include "measure/Mesh_surface.h"
#include "measure/Smoothing_measures.h"

#include <memory>

namespace comparison {

/// What is known of the true surface: itself, or only points that lie on it but for their noise.
struct Truth {
  std::shared_ptr<const Surface> surface;
  Points points;
};

/// Numbers of components, of cycles of border edges and of handles
struct Topology {
  std::size_t components = 0, holes = 0;
  long handles = 0;
};

Topology topology_of(Mesh mesh);

/// How far a reconstructed mesh and the truth are from each other
struct Mesh_distances {
  double to_truth = unknown;   ///< median distance of the mesh from the true surface
  double stray = unknown;      ///< share of the mesh that is farther than `far` from it
  double from_truth = unknown; ///< rms distance of the true points from the mesh
};

Mesh_distances distances_of(const Mesh& mesh, const Truth& truth, std::size_t samples, double far);

} // namespace comparison

#endif // POINT_SET_FLOW_BENCHMARK_MESH_MEASURES_H
