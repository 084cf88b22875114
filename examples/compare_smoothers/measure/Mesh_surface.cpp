// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh_surface.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/version.h>
#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/AABB_segment_primitive_3.h>
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_segment_primitive.h>
#include <CGAL/AABB_traits.h>
#endif
#include <CGAL/AABB_tree.h>

#include <cmath>
#include <utility>

namespace comparison {

struct Mesh_surface::Trees {
  typedef std::vector<Kernel::Segment_3> Segments;
#if CGAL_VERSION_NR >= 1060000000
  template <typename Primitive>
  using Tree = CGAL::AABB_tree<CGAL::AABB_traits_3<Kernel, Primitive>>;
  typedef CGAL::AABB_segment_primitive_3<Kernel, Segments::const_iterator> Segment_primitive;
#else
  template <typename Primitive>
  using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;
  typedef CGAL::AABB_segment_primitive<Kernel, Segments::const_iterator> Segment_primitive;
#endif
  Tree<CGAL::AABB_face_graph_triangle_primitive<Mesh>> faces;
  Segments sharp_segments;
  Tree<Segment_primitive> sharp_edges;

  Trees(const std::vector<Mesh::Face_index>& with_area, const Mesh& mesh, Segments sharp)
      : sharp_segments(std::move(sharp))
  {
    faces.insert(with_area.begin(), with_area.end(), mesh);
    faces.build();
    sharp_edges.insert(sharp_segments.cbegin(), sharp_segments.cend());
    sharp_edges.build();
  }
};

namespace {

double corner_angle(const Point_3& a, const Point_3& b, const Point_3& c)
{
  const Vector_3 u = b - a, v = c - a;
  return std::atan2(std::sqrt(CGAL::cross_product(u, v).squared_length()), u * v);
}

} // namespace

void Mesh_surface::add_face(Mesh::Face_index f)
{
  const auto v = corners(f);
  const std::array<Point_3, 3> p = triangle(f);
  const Vector_3 cross = CGAL::cross_product(p[1] - p[0], p[2] - p[0]);
  const double length = std::sqrt(cross.squared_length());
  m_area += m_face_areas[f] = length / 2.;
  if (!(length > 0.))
    return; // no area, no normal: what is closest to it is closest to a neighbor, too
  m_face_normals[f] = cross / length;
  for (std::size_t i = 0; i < 3; ++i)
    m_vertex_normals[v[i]] +=
        corner_angle(p[i], p[(i + 1) % 3], p[(i + 2) % 3]) * m_face_normals[f];
}

Vector_3 Mesh_surface::side_normal(Mesh::Face_index f, const Point_3& q) const
{
  const auto v = corners(f);
  const std::array<Point_3, 3> p = triangle(f);
  const Mesh::Halfedge_index h = m_mesh.halfedge(f);
  const Mesh::Halfedge_index opposite_edge[3] = {m_mesh.prev(h), h, m_mesh.next(h)};
  std::size_t zeros = 0, zero = 0, other = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector_3 cross = CGAL::cross_product(p[(i + 1) % 3] - q, p[(i + 2) % 3] - q);
    const bool is_zero = std::sqrt(cross.squared_length()) < 2e-7 * m_face_areas[f];
    (is_zero ? zero : other) = i;
    zeros += is_zero;
  }
  if (zeros >= 2)
    return m_vertex_normals[v[other]];
  Vector_3 normal = m_face_normals[f];
  if (zeros == 1) {
    const Mesh::Face_index g = m_mesh.face(m_mesh.opposite(opposite_edge[zero]));
    if (g != Mesh::null_face())
      normal += m_face_normals[g];
  }
  return normal;
}

Mesh_surface::Mesh_surface(Mesh mesh) : m_mesh(std::move(mesh))
{
  m_face_areas.resize(m_mesh.number_of_faces());
  m_face_normals.resize(m_mesh.number_of_faces(), CGAL::NULL_VECTOR);
  m_vertex_normals.resize(m_mesh.number_of_vertices(), CGAL::NULL_VECTOR);
  std::vector<Mesh::Face_index> with_area;
  for (const Mesh::Face_index f : m_mesh.faces()) {
    add_face(f);
    if (m_face_areas[f] > 0.)
      with_area.push_back(f);
  }

  Trees::Segments sharp;
  for (const Mesh::Edge_index e : m_mesh.edges()) {
    const Mesh::Halfedge_index h = m_mesh.halfedge(e);
    const Mesh::Face_index f = m_mesh.face(h), g = m_mesh.face(m_mesh.opposite(h));
    if (f == Mesh::null_face() || g == Mesh::null_face())
      continue;
    const bool have_normals = m_face_areas[f] > 0. && m_face_areas[g] > 0.;
    if (have_normals && m_face_normals[f] * m_face_normals[g] < std::cos(CGAL_PI / 6.))
      sharp.emplace_back(m_mesh.point(m_mesh.source(h)), m_mesh.point(m_mesh.target(h)));
  }
  m_trees = std::make_unique<const Trees>(with_area, m_mesh, std::move(sharp));
}

Mesh_surface::~Mesh_surface() = default;

Surface_point Mesh_surface::closest(const Point_3& p) const
{
  const auto found = m_trees->faces.closest_point_and_primitive(p);
  const double distance = std::sqrt(CGAL::squared_distance(p, found.first));
  const bool inside = (p - found.first) * side_normal(found.second, found.first) < 0.;
  return {found.first, m_face_normals[found.second], inside ? -distance : distance};
}

double Mesh_surface::distance_to_sharp_edge(const Point_3& p) const
{
  return m_trees->sharp_segments.empty() ? Surface::distance_to_sharp_edge(p)
                                         : std::sqrt(m_trees->sharp_edges.squared_distance(p));
}

} // namespace comparison
