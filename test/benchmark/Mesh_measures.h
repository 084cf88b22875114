// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_BENCHMARK_MESH_MEASURES_H
#define BALANCED_FLOW_BENCHMARK_MESH_MEASURES_H

#include "comparison/Smoothing_measures.h"
#include "comparison/sample_mesh.h"

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>

#include <memory>
#include <optional>

/// What is known of the true surface: itself, or only points that lie on it but for their noise.
struct Truth {
  std::shared_ptr<const Surface> surface;
  Points points;
};

/// What is measured of a reconstructed mesh
struct Mesh_measures {
  std::size_t components = 0, holes = 0; ///< holes: cycles of border edges
  long handles = 0;
  double to_truth = unknown;   ///< rms distance of the mesh from the true surface
  double from_truth = unknown; ///< rms distance of the true points from the mesh
};

inline Mesh_measures measure_mesh(Mesh mesh, const Truth& truth, std::size_t samples)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  Mesh_measures result;
  auto components = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:part", 0).first;
  result.components = PMP::connected_components(mesh, components);
  std::vector<Mesh::Halfedge_index> borders;
  PMP::extract_boundary_cycles(mesh, std::back_inserter(borders));
  result.holes = borders.size();
  const long euler =
      long(mesh.number_of_vertices()) - long(mesh.number_of_edges()) + long(mesh.number_of_faces());
  result.handles = (2 * long(result.components) - long(result.holes) - euler) / 2;

  const Mesh_surface reconstructed(std::move(mesh));
  Error_sum to, from;
  if (truth.surface) {
    for (const Point_3& p : sample_mesh(reconstructed, samples, 1).points)
      to.add(truth.surface->closest(p).signed_distance);
    result.to_truth = to.rms();
  }
  for (const Point_3& p : truth.points)
    from.add(reconstructed.closest(p).signed_distance);
  result.from_truth = from.rms();
  return result;
}

#endif // BALANCED_FLOW_BENCHMARK_MESH_MEASURES_H
