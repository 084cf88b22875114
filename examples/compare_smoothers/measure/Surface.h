// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef COMPARISON_SURFACE_H
#define COMPARISON_SURFACE_H

#include <CGAL/Simple_cartesian.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace comparison {

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point_3;
typedef Kernel::Vector_3 Vector_3;
typedef std::vector<Point_3> Points;
typedef std::vector<Vector_3> Vectors;

/// Where a surface is nearest to a point.
struct Surface_point {
  Point_3 point;
  Vector_3 normal;        ///< of the surface there, a unit vector
  double signed_distance; ///< positive on the side of the normal: outside
};

/// The true surface, as the measures see it.
class Surface {
public:
  virtual ~Surface() = default;
  virtual Surface_point closest(const Point_3& p) const = 0;
  /// infinity if there are no sharp edges, or if they are not known
  virtual double distance_to_sharp_edge(const Point_3&) const
  {
    return std::numeric_limits<double>::infinity();
  }
};

/// Points on a surface, and what is known of the surface there.
struct Samples {
  Points points;
  Vectors normals;
  std::vector<char> near_edge; ///< whether a sharp edge of the surface is near
};

/// Marks the samples that a sharp edge of the surface is near to.
inline void find_samples_near_edges(Samples& samples, const Surface& surface, double distance)
{
  samples.near_edge.clear();
  for (const Point_3& p : samples.points)
    samples.near_edge.push_back(surface.distance_to_sharp_edge(p) <= distance);
}

} // namespace comparison

#endif // COMPARISON_SURFACE_H
