// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh_measures.h"
#include "Epick_points.h"

#include "measure/read_mesh.h"
#include "measure/sample_mesh.h"

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>

namespace comparison {

Reconstructed mesh_of(const Epick_points& points, const Triangles& triangles)
{
  Points soup;
  for (const Epick::Point_3& p : points)
    soup.emplace_back(p.x(), p.y(), p.z());
  Polygons polygons;
  for (const auto& t : triangles)
    polygons.push_back({t[0], t[1], t[2]});
  return make_mesh(std::move(soup), std::move(polygons));
}

Topology topology_of(Mesh mesh)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  auto components = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:part", 0).first;
  std::vector<Mesh::Halfedge_index> borders;
  PMP::extract_boundary_cycles(mesh, std::back_inserter(borders));
  Topology result{PMP::connected_components(mesh, components), borders.size(), 0};
  const long euler =
      long(mesh.number_of_vertices()) - long(mesh.number_of_edges()) + long(mesh.number_of_faces());
  result.handles = (2 * long(result.components) - long(result.holes) - euler) / 2;
  return result;
}

Mesh_distances distances_of(const Mesh& mesh, const Truth& truth, std::size_t samples, double far)
{
  Mesh_distances result;
  const Mesh_surface reconstructed(mesh);
  if (truth.surface) {
    std::vector<double> distances;
    for (const Point_3& p : sample_mesh(reconstructed, samples, 1).points)
      distances.push_back(std::abs(truth.surface->closest(p).signed_distance));
    std::sort(distances.begin(), distances.end());
    result.to_truth = distances[distances.size() / 2];
    result.stray =
        double(distances.end() - std::upper_bound(distances.begin(), distances.end(), far)) /
        double(distances.size());
  }
  Error_sum from;
  for (const Point_3& p : truth.points)
    from.add(reconstructed.closest(p).signed_distance);
  result.from_truth = from.rms();
  return result;
}

} // namespace comparison
