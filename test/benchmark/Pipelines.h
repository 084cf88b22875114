// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_BENCHMARK_PIPELINES_H
#define BALANCED_FLOW_BENCHMARK_PIPELINES_H

#include "comparison/Smoothers.h"
#include "comparison/read_mesh.h"

#include <CGAL/Advancing_front_surface_reconstruction.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Scale_space_reconstruction_3/Balanced_flow_smoother.h>
#include <CGAL/Scale_space_reconstruction_3/Jet_smoother.h>
#include <CGAL/Scale_space_surface_reconstruction_3.h>
#include <CGAL/compute_average_spacing.h>
#include <CGAL/poisson_surface_reconstruction.h>

#include <array>

/// CGAL's reconstructions, each from points to a mesh; without a mesh where it fails.

typedef CGAL::Exact_predicates_inexact_constructions_kernel Epick;
typedef std::vector<Epick::Point_3> Epick_points;
typedef std::vector<std::array<std::size_t, 3>> Triangles;

inline Epick_points to_epick(const Points& points)
{
  Epick_points result;
  for (const Point_3& p : points)
    result.emplace_back(p.x(), p.y(), p.z());
  return result;
}

template <typename Epick_range>
std::optional<Mesh> mesh_of(const Epick_range& points, const Triangles& triangles)
{
  Points soup;
  for (const auto& p : points)
    soup.emplace_back(p.x(), p.y(), p.z());
  Polygons polygons;
  for (const auto& t : triangles)
    polygons.push_back({t[0], t[1], t[2]});
  CGAL::Polygon_mesh_processing::remove_isolated_points_in_polygon_soup(soup, polygons);
  return make_mesh(std::move(soup), std::move(polygons));
}

inline std::optional<Mesh> advancing_front(const Points& points)
{
  const Epick_points epick = to_epick(points);
  Triangles triangles;
  CGAL::advancing_front_surface_reconstruction(epick.begin(), epick.end(),
                                               std::back_inserter(triangles));
  return mesh_of(epick, triangles);
}

/// Normals on consistent sides: PCA's with 18 neighbors if none are given
inline Vectors oriented_normals(const Points& points, const Vectors& normals)
{
  if (normals.empty())
    return normals_in_order(with_normals<Concurrency_tag>(points, true));
  Numbered_points numbered;
  for (std::size_t i = 0; i < points.size(); ++i)
    numbered.emplace_back(points[i], normals[i], i);
  CGAL::mst_orient_normals(numbered, 18, numbered_point_maps());
  return normals_in_order(numbered);
}

inline std::optional<Mesh> poisson(const Points& points, const Vectors& normals)
{
  typedef std::pair<Epick::Point_3, Epick::Vector_3> Point_with_normal;
  typedef CGAL::Surface_mesh<Epick::Point_3> Epick_mesh;
  const Vectors oriented = oriented_normals(points, normals);
  std::vector<Point_with_normal> input;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point_3& p = points[i];
    const Vector_3& n = oriented[i];
    input.emplace_back(Epick::Point_3(p.x(), p.y(), p.z()), Epick::Vector_3(n.x(), n.y(), n.z()));
  }
  Epick_mesh mesh;
  const double spacing = CGAL::compute_average_spacing<Concurrency_tag>(points, 6);
  if (!CGAL::poisson_surface_reconstruction_delaunay(
          input.begin(), input.end(), CGAL::First_of_pair_property_map<Point_with_normal>(),
          CGAL::Second_of_pair_property_map<Point_with_normal>(), mesh, spacing))
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

/// With CGAL's default mesher, alpha shapes, of a radius that CGAL estimates from the points
/// themselves. The smoother is applied so many times.
template <typename Smoother>
std::optional<Mesh> scale_space(const Points& points, std::size_t times, const Smoother& smoother)
{
  typedef CGAL::Scale_space_reconstruction_3::Weighted_PCA_smoother<Epick> Radius_estimator;
  Epick_points epick = to_epick(points);
  CGAL::Scale_space_surface_reconstruction_3<Epick> reconstruction(epick.begin(), epick.end());
  Radius_estimator estimator;
  estimator(epick.begin(), epick.end()); // it tells the radius after it has smoothed
  reconstruction.increase_scale(times, smoother);
  typedef CGAL::Scale_space_reconstruction_3::Alpha_shape_mesher<Epick> Mesher;
  reconstruction.reconstruct_surface(Mesher(estimator.squared_radius(), false, true));
  Triangles triangles;
  for (auto f = reconstruction.facets_begin(); f != reconstruction.facets_end(); ++f)
    triangles.push_back({(*f)[0], (*f)[1], (*f)[2]});
  return mesh_of(Epick_points(reconstruction.points_begin(), reconstruction.points_end()),
                 triangles);
}

#endif // BALANCED_FLOW_BENCHMARK_PIPELINES_H
