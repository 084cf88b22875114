// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef COMPARISON_MESH_SURFACE_H
#define COMPARISON_MESH_SURFACE_H

#include "Surface.h"

#include <CGAL/Surface_mesh.h>

#include <array>
#include <memory>

namespace comparison {

typedef CGAL::Surface_mesh<Point_3> Mesh;

/// A triangle mesh as the true surface. Its edges are sharp where the normals of their faces differ
/// by more than 30 degrees.
///
/// The side of a point is that of the angle-weighted normal at the closest vertex, edge or face
/// (Baerentzen and Aanaes 2005): right at sharp and at concave vertices, and it needs neither a
/// closed mesh nor one without self-intersections, which inside and outside would.
class Mesh_surface : public Surface {
  struct Trees; // of faces with an area and of sharp edges

  Mesh m_mesh;
  double m_area = 0.;
  std::vector<double> m_face_areas;
  Vectors m_face_normals, m_vertex_normals;
  std::unique_ptr<const Trees> m_trees;

  /// The corners of a face: the first halfedge ends in the first one
  std::array<Mesh::Vertex_index, 3> corners(Mesh::Face_index f) const
  {
    const Mesh::Halfedge_index h = m_mesh.halfedge(f);
    return {m_mesh.target(h), m_mesh.target(m_mesh.next(h)), m_mesh.source(h)};
  }

  void add_face(Mesh::Face_index f);
  /// The direction that tells the sides of the mesh apart at a point of a face
  Vector_3 side_normal(Mesh::Face_index f, const Point_3& q) const;

public:
  explicit Mesh_surface(Mesh mesh);
  ~Mesh_surface() override;

  Surface_point closest(const Point_3& p) const override;
  double distance_to_sharp_edge(const Point_3& p) const override;

  const Mesh& mesh() const { return m_mesh; }
  double area() const { return m_area; }
  const std::vector<double>& face_areas() const { return m_face_areas; }
  const Vector_3& normal(Mesh::Face_index f) const { return m_face_normals[f]; }
  std::array<Point_3, 3> triangle(Mesh::Face_index f) const
  {
    const auto v = corners(f);
    return {m_mesh.point(v[0]), m_mesh.point(v[1]), m_mesh.point(v[2])};
  }
};

} // namespace comparison

#endif // COMPARISON_MESH_SURFACE_H
