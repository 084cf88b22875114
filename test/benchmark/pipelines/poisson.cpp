// SPDX-License-Identifier: GPL-3.0-or-later
#include "Epick_points.h"

#include "measure/Smoothing_measures.h"

#include <CGAL/compute_average_spacing.h>
#include <CGAL/mst_orient_normals.h>
#include <CGAL/poisson_surface_reconstruction.h>
#include <CGAL/version.h>

#include <map>

namespace comparison {

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

typedef std::pair<Epick::Point_3, Epick::Vector_3> Point_with_normal;
typedef CGAL::First_of_pair_property_map<Point_with_normal> Point_map;
typedef CGAL::Second_of_pair_property_map<Point_with_normal> Normal_map;

// closer to the zero set than by default, so that not the mesher's error counts
const double angle = 20., radius = 30., distance = .1;

#if CGAL_VERSION_MAJOR >= 6

Reconstructed zero_set(const std::vector<Point_with_normal>& input, double spacing)
{
  CGAL::Surface_mesh<Epick::Point_3> mesh;
  if (!CGAL::poisson_surface_reconstruction_delaunay(input.begin(), input.end(), Point_map(),
                                                     Normal_map(), mesh, spacing, angle, radius,
                                                     distance))
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

#else

// The same in steps: CGAL 5's function reads beyond the end of the facets and crashes now and then,
// where the mesher leaves a surface that is not a manifold. A soup of triangles needs none.
Reconstructed zero_set(const std::vector<Point_with_normal>& input, double spacing)
{
  typedef CGAL::Surface_mesh_default_triangulation_3 Triangulation;
  typedef CGAL::Surface_mesh_complex_2_in_triangulation_3<Triangulation> Complex;
  typedef CGAL::Poisson_reconstruction_function<Epick> Function;

  Function function(input.begin(), input.end(), Point_map(), Normal_map());
  if (!function.compute_implicit_function())
    return std::nullopt;
  const double ball = 5. * std::sqrt(function.bounding_sphere().squared_radius());
  const CGAL::Implicit_surface_3<Epick, Function> surface(
      function, Epick::Sphere_3(function.get_inner_point(), ball * ball),
      distance * spacing / 1000. / ball);
  Triangulation triangulation;
  Complex complex(triangulation);
  CGAL::make_surface_mesh(complex, surface,
                          CGAL::Surface_mesh_default_criteria_3<Triangulation>(
                              angle, radius * spacing, distance * spacing),
                          CGAL::Manifold_with_boundary_tag());

  Epick_points vertices;
  Triangles triangles;
  std::map<Triangulation::Vertex_handle, std::size_t> number;
  for (auto f = complex.facets_begin(); f != complex.facets_end(); ++f) {
    triangles.emplace_back();
    for (int i = 0; i < 3; ++i) {
      const auto v = f->first->vertex(Triangulation::vertex_triple_index(f->second, i));
      const auto known = number.emplace(v, vertices.size());
      if (known.second)
        vertices.push_back(v->point());
      triangles.back()[std::size_t(i)] = known.first->second;
    }
  }
  return mesh_of(vertices, triangles);
}

#endif

} // namespace

Reconstructed poisson(const Points& points, const Vectors& normals, const Vectors& sides)
{
  const Vectors oriented = oriented_normals(points, normals, sides);
  const Epick_points epick = to_epick(points);
  std::vector<Point_with_normal> input;
  for (std::size_t i = 0; i < points.size(); ++i)
    input.emplace_back(epick[i],
                       Epick::Vector_3(oriented[i].x(), oriented[i].y(), oriented[i].z()));
  return zero_set(input, CGAL::compute_average_spacing<CGAL::Parallel_if_available_tag>(points, 6));
}

} // namespace comparison
