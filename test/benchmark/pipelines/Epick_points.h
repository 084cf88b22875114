// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_BENCHMARK_EPICK_POINTS_H
#define POINT_SET_FLOW_BENCHMARK_EPICK_POINTS_H

#include "Pipelines.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <array>

namespace comparison {

/// To and from the kernel that the reconstructions need

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

Reconstructed mesh_of(const Epick_points& points, const Triangles& triangles);

} // namespace comparison

#endif // POINT_SET_FLOW_BENCHMARK_EPICK_POINTS_H
