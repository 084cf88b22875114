// SPDX-License-Identifier: GPL-3.0-or-later
#include "read_mesh.h"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>

namespace comparison {

namespace {

/// Turns the faces of closed components so that the normals point outwards.
void orient_outwards(Mesh& mesh)
{
  auto components = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:component", 0).first;
  const std::size_t n = CGAL::Polygon_mesh_processing::connected_components(mesh, components);
  std::vector<double> volumes(n, 0.);
  std::vector<char> closed(n, true);
  std::vector<std::vector<Mesh::Face_index>> faces(n);
  for (const Mesh::Face_index f : mesh.faces()) {
    const std::size_t c = components[f];
    faces[c].push_back(f);
    const Mesh::Halfedge_index h = mesh.halfedge(f);
    volumes[c] += CGAL::determinant(mesh.point(mesh.source(h)) - CGAL::ORIGIN,
                                    mesh.point(mesh.target(h)) - CGAL::ORIGIN,
                                    mesh.point(mesh.target(mesh.next(h))) - CGAL::ORIGIN);
    for (const Mesh::Halfedge_index side : mesh.halfedges_around_face(h))
      if (mesh.is_border(mesh.opposite(side)))
        closed[c] = false;
  }
  for (std::size_t c = 0; c < n; ++c)
    if (closed[c] && volumes[c] < 0.)
      CGAL::Polygon_mesh_processing::reverse_face_orientations(faces[c], mesh);
}

} // namespace

std::optional<Mesh> make_mesh(Points points, Polygons polygons)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  PMP::repair_polygon_soup(points, polygons);
  PMP::orient_polygon_soup(points, polygons); // splits what is not manifold
  Mesh mesh;
  if (polygons.empty() || !PMP::is_polygon_soup_a_polygon_mesh(polygons))
    return std::nullopt;
  PMP::polygon_soup_to_polygon_mesh(points, polygons, mesh);
  if (!PMP::triangulate_faces(mesh))
    return std::nullopt;
  mesh.collect_garbage(); // indices serve as positions in vectors
  orient_outwards(mesh);
  return mesh;
}

std::optional<Mesh> read_mesh(const std::string& file, Unit_sphere_map& to_unit_sphere)
{
  Points points;
  Polygons polygons;
  if (!CGAL::IO::read_polygon_soup(file, points, polygons) || polygons.empty())
    return std::nullopt;
  CGAL::Polygon_mesh_processing::remove_isolated_points_in_polygon_soup(points, polygons);
  to_unit_sphere = Unit_sphere_map::of(points);
  to_unit_sphere.apply(points);
  return make_mesh(std::move(points), std::move(polygons));
}

} // namespace comparison
