// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_TEST_STAGE_CLOUDS_H
#define CGAL_POINT_SET_FLOW_TEST_STAGE_CLOUDS_H

#include "shapes.h"

#include <CGAL/Point_set_flow/internal/neighbors/Neighbor_graph.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <vector>

// What the tests of the stages have in common
namespace stages {

using namespace CGAL::Point_set_flow;

typedef internal::Loops<CGAL::Sequential_tag> Loops;

inline void require_same_neighborhood(const internal::Neighbor_graph& a,
                                      const internal::Neighbor_graph& b, std::size_t i)
{
  BOOST_REQUIRE(a.size(i) == b.size(i));
  BOOST_REQUIRE(a.radius(i) == b.radius(i));
  for (std::size_t j = 0; j < a.size(i); ++j)
    BOOST_REQUIRE(a.neighbors(i)[j] == b.neighbors(i)[j]);
}

// The stages work on arrays.
typedef internal::Array<Point_3> Points;

inline Points array(const shapes::Points& points) { return Points(points.begin(), points.end()); }

/// A surface, a lattice, where many distances are equal, and a point far away
inline Points points_of_all_kinds()
{
  Points points = array(shapes::cube(12));
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j)
      for (int l = 0; l < 5; ++l)
        points.emplace_back(3. + i, j, l);
  points.emplace_back(1e6, 0., 0.);
  return points;
}

/// Three parts that alternate along the points
/// \param run the number of points in a row that are in one part
inline internal::Array<std::uint32_t> three_parts(std::size_t n, std::size_t run)
{
  internal::Array<std::uint32_t> part_of;
  for (std::size_t i = 0; i < n; ++i)
    part_of.push_back(std::uint32_t(i / run % 3));
  return part_of;
}

/// All other points, nearest first, ties by index
inline std::vector<internal::Neighbor> by_distance(const Points& points, std::size_t i)
{
  std::vector<internal::Neighbor> sorted;
  for (std::size_t j = 0; j < points.size(); ++j)
    if (j != i)
      sorted.push_back({CGAL::squared_distance(points[i], points[j]), std::uint32_t(j)});
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

} // namespace stages

#endif // CGAL_POINT_SET_FLOW_TEST_STAGE_CLOUDS_H
