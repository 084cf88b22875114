// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_BENCHMARK_BENCHMARK_SHAPES_H
#define POINT_SET_FLOW_BENCHMARK_BENCHMARK_SHAPES_H

#include "measure/read_mesh.h"

#include <memory>

namespace comparison {

/// The shapes of the benchmark: meshes of CGAL's data, which are scaled to radius 1, and generated
/// ones of known angles and thickness.

typedef std::vector<std::string> Names;

inline Names tuned_shapes()
{
  return {"fandisk", "elephant",  "octahedron", "camel", "cow",
          "cube",    "armadillo", "pig",        "elk",   "anchor_dense"};
}
inline Names untuned_shapes()
{
  return {"dino",  "hand",  "joint",       "bull",         "knot1",
          "femur", "homer", "triceratops", "couplingdown", "spool"};
}
inline Names thin_shapes()
{
  return {"blade", "turbine", "rotor_small", "plate-1", "plate-2", "plate-3", "plate-4"};
}

/// A prism over a polygon in the plane, counterclockwise
inline std::optional<Mesh> prism(const std::vector<std::pair<double, double>>& polygon,
                                 double height)
{
  const std::size_t n = polygon.size();
  Points points;
  Polygons faces(2);
  for (const double z : {-height / 2., height / 2.})
    for (const auto& corner : polygon)
      points.emplace_back(corner.first, corner.second, z);
  for (std::size_t i = 0; i < n; ++i) {
    faces[0].push_back(n - 1 - i);
    faces[1].push_back(n + i);
    faces.push_back({i, (i + 1) % n, n + (i + 1) % n, n + i});
  }
  Unit_sphere_map::of(points).apply(points);
  return make_mesh(points, faces);
}

/// A square plate with sheets so many spacings of n samples apart: of radius 1 it has two faces with
/// an area of 2 each.
inline std::optional<Mesh> plate(double spacings, std::size_t n)
{
  const double half = std::sqrt(.5);
  return prism({{-half, -half}, {half, -half}, {half, half}, {-half, half}},
               spacings * std::sqrt(4. / double(n)));
}

/// An open surface: waves over a square
inline std::optional<Mesh> waves()
{
  const std::size_t m = 80;
  Points points;
  Polygons faces;
  for (std::size_t i = 0; i <= m; ++i)
    for (std::size_t j = 0; j <= m; ++j) {
      const double x = 2. * double(i) / m - 1., y = 2. * double(j) / m - 1.;
      points.emplace_back(x, y, .15 * std::sin(4. * x) * std::cos(3. * y));
      const std::size_t v = points.size() - 1, w = v - m - 1; // v is the upper right corner
      if (i > 0 && j > 0)
        faces.push_back({w - 1, v - 1, v, w});
    }
  Unit_sphere_map::of(points).apply(points);
  return make_mesh(points, faces);
}

/// Whether the name of a shape is that of a mesh file
inline bool is_file(const std::string& name) { return name.find('.') != name.npos; }

/// Empty if the shape can not be had.
inline std::unique_ptr<Mesh_surface> load_shape(const std::string& name, std::size_t n)
{
  std::optional<Mesh> mesh;
  Unit_sphere_map map;
  if (name.rfind("plate-", 0) == 0)
    mesh = plate(std::stod(name.substr(6)), n);
  else if (name == "box") // creases and corners of 90 degrees
    mesh = prism({{-.6, -.4}, {.6, -.4}, {.6, .4}, {-.6, .4}}, 1.);
  else if (name == "wedge-30") // two faces that meet at 30 degrees
    mesh = prism({{0., 0.}, {1., -std::tan(CGAL_PI / 12.)}, {1., std::tan(CGAL_PI / 12.)}}, 1.);
  else if (name == "prism-30") { // creases where the normals differ by 30 degrees
    std::vector<std::pair<double, double>> polygon;
    for (int i = 0; i < 12; ++i)
      polygon.emplace_back(std::cos(i * CGAL_PI / 6.), std::sin(i * CGAL_PI / 6.));
    mesh = prism(polygon, 1.5);
  }
  else if (name == "waves")
    mesh = waves();
  else
    mesh = read_mesh(is_file(name) ? name : CGAL::data_file_path("meshes/" + name + ".off"), map);
  return mesh ? std::make_unique<Mesh_surface>(std::move(*mesh)) : nullptr;
}

} // namespace comparison

#endif // POINT_SET_FLOW_BENCHMARK_BENCHMARK_SHAPES_H
