// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef COMPARISON_READ_MESH_H
#define COMPARISON_READ_MESH_H

#include "Mesh_surface.h"

#include <algorithm>
#include <optional>
#include <string>

namespace comparison {

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

/// Makes a triangle mesh of polygons that may be unoriented, not manifold and unused by each other.
/// The normals of closed components point outwards.
std::optional<Mesh> make_mesh(Points points, Polygons polygons);

/// Reads a mesh; empty if the file has none, or one that can not be mended.
std::optional<Mesh> read_mesh(const std::string& file, Unit_sphere_map& to_unit_sphere);

} // namespace comparison

#endif // COMPARISON_READ_MESH_H
