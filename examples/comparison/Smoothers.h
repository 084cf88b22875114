// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_COMPARISON_SMOOTHERS_H
#define BALANCED_FLOW_COMPARISON_SMOOTHERS_H

#include "Numbered_points.h"

#include <CGAL/balanced_flow_smooth_point_set.h>
#include <CGAL/bilateral_smooth_point_set.h>
#include <CGAL/jet_smooth_point_set.h>
#include <CGAL/wlop_simplify_and_regularize_point_set.h>

#include <algorithm>
#include <cmath>

/// The smoothers that are compared, each from points to points.

typedef CGAL::Parallel_if_available_tag Concurrency_tag;

struct Smoothed {
  Points points;
  Vectors normals;         ///< if the smoother has any to give
  bool same_points = true; ///< whether point i was point i before
};

inline bool all_finite(const Points& points)
{
  return std::all_of(points.begin(), points.end(), [](const Point_3& p) {
    return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
  });
}

inline Smoothed jet(const Points& noisy, unsigned int k, int times = 1)
{
  Smoothed result{noisy, {}};
  for (int i = 0; i < times; ++i)
    CGAL::jet_smooth_point_set<Concurrency_tag>(result.points, k);
  return result;
}

/// With a sharpness angle of 25 degrees, of points with oriented normals.
inline Smoothed bilateral(Numbered_points points, unsigned int k, int times = 1)
{
  for (int i = 0; i < times; ++i)
    CGAL::bilateral_smooth_point_set<Concurrency_tag>(points, k,
                                                      numbered_point_maps().sharpness_angle(25.));
  Smoothed result{Points(points.size()), {}};
  for (const Numbered_point& p : points)
    result.points[std::get<2>(p)] = std::get<0>(p);
  return result;
}

/// With the normals that it needs: PCA's with 18 neighbors.
inline Smoothed bilateral(const Points& noisy, unsigned int k, int times = 1)
{
  return bilateral(with_normals<Concurrency_tag>(noisy, true), k, times);
}

/// Keeps as many points as there were, but they are others.
inline Smoothed wlop(Points noisy)
{
  Smoothed result;
  CGAL::wlop_simplify_and_regularize_point_set<Concurrency_tag>(
      noisy, std::back_inserter(result.points), CGAL::parameters::select_percentage(100.));
  result.same_points = false;
  return result;
}

/// Numbers 0 to n-1, which the maps take as points
inline std::vector<std::size_t> numbers(std::size_t n)
{
  std::vector<std::size_t> result(n);
  for (std::size_t i = 0; i < n; ++i)
    result[i] = i;
  return result;
}

/// A flow as the paper has it, by covariance analysis.
template <typename Flow>
Smoothed paper_flow(const Points& noisy, const Flow& flow)
{
  Smoothed result{noisy, Vectors(noisy.size(), CGAL::NULL_VECTOR)};
  std::vector<std::size_t> indices = numbers(noisy.size());
  CGAL::balanced_flow_smooth_point_set<Concurrency_tag>(
      indices, CGAL::parameters::flow(flow)
                   .curvature(CGAL::Point_set_flow::Covariance_curvature())
                   .point_map(CGAL::make_property_map(result.points))
                   .normal_map(CGAL::make_property_map(result.normals)));
  return result;
}

/// This package with its defaults.
inline Smoothed balanced_flow(const Points& noisy)
{
  Smoothed result{noisy, Vectors(noisy.size(), CGAL::NULL_VECTOR)};
  std::vector<std::size_t> indices = numbers(noisy.size());
  CGAL::balanced_flow_smooth_point_set<Concurrency_tag>(
      indices, CGAL::parameters::point_map(CGAL::make_property_map(result.points))
                   .normal_map(CGAL::make_property_map(result.normals)));
  return result;
}

/// This package with a neighborhood size.
inline Smoothed balanced_flow(const Points& noisy, unsigned int k)
{
  Smoothed result{noisy, {}};
  CGAL::balanced_flow_smooth_point_set<Concurrency_tag>(result.points, k);
  return result;
}

#endif // BALANCED_FLOW_COMPARISON_SMOOTHERS_H
