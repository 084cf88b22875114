// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef COMPARISON_NUMBERED_POINTS_H
#define COMPARISON_NUMBERED_POINTS_H

#include "Surface.h"

#include <CGAL/Named_function_parameters.h>
#include <CGAL/property_map.h>

#include <tuple>

namespace comparison {

/// Points with normals, which find back to their place when CGAL reorders them
typedef std::tuple<Point_3, Vector_3, std::size_t> Numbered_point;
typedef std::vector<Numbered_point> Numbered_points;

/// The property maps of numbered points, as named parameters
inline auto numbered_point_maps()
{
  return CGAL::parameters::point_map(CGAL::Nth_of_tuple_property_map<0, Numbered_point>())
      .normal_map(CGAL::Nth_of_tuple_property_map<1, Numbered_point>());
}

/// PCA normals, on consistent sides if wanted. Orienting reorders the points, so they carry their
/// numbers. For both concurrency tags.
template <typename ConcurrencyTag>
Numbered_points with_normals(const Points& points, bool orient, unsigned int k = 18);

/// The normals in the order of the points that were given
inline Vectors normals_in_order(const Numbered_points& points)
{
  Vectors normals(points.size());
  for (const Numbered_point& p : points)
    normals[std::get<2>(p)] = std::get<1>(p);
  return normals;
}

} // namespace comparison

#endif // COMPARISON_NUMBERED_POINTS_H
