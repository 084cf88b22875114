// SPDX-License-Identifier: GPL-3.0-or-later
#include "Epick_points.h"

#include "comparison/Smoothing_measures.h"

#include <CGAL/compute_average_spacing.h>
#include <CGAL/poisson_surface_reconstruction.h>

namespace {

Vectors oriented_normals(const Points& points, Vectors normals, const Vectors& sides)
{
  if (normals.empty())
    return oriented_normals(points, pca_normals(points), sides);
  if (sides.empty()) {
    Numbered_points numbered;
    for (std::size_t i = 0; i < points.size(); ++i)
      numbered.emplace_back(points[i], normals[i], i);
    CGAL::mst_orient_normals(numbered, 18, numbered_point_maps());
    return normals_in_order(numbered);
  }
  for (std::size_t i = 0; i < points.size(); ++i)
    if (normals[i] * sides[i] < 0.)
      normals[i] = -normals[i];
  return normals;
}

} // namespace

Reconstructed poisson(const Points& points, const Vectors& normals, const Vectors& sides)
{
  typedef std::pair<Epick::Point_3, Epick::Vector_3> Point_with_normal;
  typedef CGAL::Surface_mesh<Epick::Point_3> Epick_mesh;
  const Vectors oriented = oriented_normals(points, normals, sides);
  const Epick_points epick = to_epick(points);
  std::vector<Point_with_normal> input;
  for (std::size_t i = 0; i < points.size(); ++i)
    input.emplace_back(epick[i],
                       Epick::Vector_3(oriented[i].x(), oriented[i].y(), oriented[i].z()));
  Epick_mesh mesh; // closer to the zero set than by default, so that not the mesher's error counts
  const double spacing = CGAL::compute_average_spacing<CGAL::Parallel_if_available_tag>(points, 6);
  if (!CGAL::poisson_surface_reconstruction_delaunay(
          input.begin(), input.end(), CGAL::First_of_pair_property_map<Point_with_normal>(),
          CGAL::Second_of_pair_property_map<Point_with_normal>(), mesh, spacing, 20., 30., .1))
    return std::nullopt;
  Epick_points vertices;
  for (const auto v : mesh.vertices())
    vertices.push_back(mesh.point(v));
  Triangles triangles;
  for (const auto f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    triangles.push_back({mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))});
  }
  return mesh_of(vertices, triangles);
}
