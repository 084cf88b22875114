// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_BENCHMARK_RAY_CASTER_H
#define POINT_SET_FLOW_BENCHMARK_RAY_CASTER_H

#include "measure/Mesh_surface.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/version.h>
#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_traits.h>
#endif
#include <CGAL/AABB_tree.h>

#include <cmath>
#include <optional>

namespace comparison {

/// The first point of a mesh that a ray meets.
class Ray_caster {
  typedef CGAL::AABB_face_graph_triangle_primitive<Mesh> Primitive;
#if CGAL_VERSION_NR >= 1060000000
  typedef CGAL::AABB_tree<CGAL::AABB_traits_3<Kernel, Primitive>> Tree;
#else
  typedef CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> Tree;
#endif
  Tree m_tree;

public:
  explicit Ray_caster(const Mesh& mesh)
  {
    m_tree.insert(faces(mesh).first, faces(mesh).second, mesh);
    m_tree.build();
  }
  /// The distance to it; empty if there is none
  std::optional<double> range(const Point_3& from, const Vector_3& direction) const
  {
    const auto found = m_tree.first_intersection(Kernel::Ray_3(from, direction));
    const Point_3* const hit = found ? point_of(found->first) : nullptr;
    if (!hit)
      return std::nullopt; // or it runs within a face
    return std::sqrt(CGAL::squared_distance(from, *hit));
  }

private:
  // a variant of Boost or, from CGAL 6 on, of the standard library
  template <typename Variant>
  static const Point_3* point_of(const Variant& variant)
  {
#if CGAL_VERSION_NR >= 1060000000
    return std::get_if<Point_3>(&variant);
#else
    return boost::get<Point_3>(&variant);
#endif
  }
};

} // namespace comparison

#endif // POINT_SET_FLOW_BENCHMARK_RAY_CASTER_H
