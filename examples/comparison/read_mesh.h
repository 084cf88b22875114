// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_COMPARISON_READ_MESH_H
#define BALANCED_FLOW_COMPARISON_READ_MESH_H

#include "Mesh_surface.h"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>

#include <algorithm>
#include <optional>
#include <string>

typedef std::vector<std::vector<std::size_t>> Polygons;

/// A similarity that takes data to the origin and into the unit sphere.
struct Unit_sphere_map {
  Vector_3 center = CGAL::NULL_VECTOR;
  double radius = 1.;

  /// of the points' bounding box, as the protocol of the learned denoisers has it
  static Unit_sphere_map of(const Points& points)
  {
    Unit_sphere_map map;
    const CGAL::Bbox_3 box = CGAL::bbox_3(points.begin(), points.end());
    map.center = {(box.xmin() + box.xmax()) / 2, (box.ymin() + box.ymax()) / 2,
                  (box.zmin() + box.zmax()) / 2};
    double squared = 0.;
    for (const Point_3& p : points)
      squared = (std::max)(squared, ((p - CGAL::ORIGIN) - map.center).squared_length());
    map.radius = squared > 0. ? std::sqrt(squared) : 1.;
    return map;
  }
  Point_3 operator()(const Point_3& p) const
  {
    return CGAL::ORIGIN + ((p - CGAL::ORIGIN) - center) / radius;
  }
  Point_3 inverse(const Point_3& p) const
  {
    return CGAL::ORIGIN + (radius * (p - CGAL::ORIGIN) + center);
  }
  void apply(Points& points) const
  {
    std::transform(points.begin(), points.end(), points.begin(), *this);
  }
};

/// Turns the faces of closed components so that the normals point outwards.
inline void orient_outwards(Mesh& mesh)
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

/// Makes a triangle mesh of polygons that may be unoriented, not manifold and unused by each other.
inline std::optional<Mesh> make_mesh(Points points, Polygons polygons)
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

/// Reads a mesh; empty if the file has none, or one that can not be mended.
inline std::optional<Mesh> read_mesh(const std::string& file, Unit_sphere_map& to_unit_sphere)
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

#endif // BALANCED_FLOW_COMPARISON_READ_MESH_H
