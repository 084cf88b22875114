// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_BENCHMARK_WALL_FRAME_H
#define POINT_SET_FLOW_BENCHMARK_WALL_FRAME_H

#include "measure/Smoothing_measures.h"

#include <CGAL/centroid.h>

#include <map>

namespace comparison {

/// A frame of the largest upright wall of a building whose z axis is up: coordinates along the wall,
/// up, and out of it.
class Wall_frame {
  Point_3 m_origin;
  Vector_3 m_along, m_out;

  /// The level direction that most PCA normals are within 5 degrees of
  static Vector_3 most_frequent_level_direction(const Vectors& normals)
  {
    std::vector<std::size_t> counts(180, 0); // of lines, by degrees
    for (const Vector_3& n : normals)
      if (std::abs(n.z()) < .1) {
        const double degrees = std::atan2(n.y(), n.x()) * 180. / CGAL_PI;
        ++counts[std::size_t(degrees + 360.) % 180];
      }
    std::size_t best = 0, best_count = 0;
    for (std::size_t d = 0; d < 180; ++d) {
      std::size_t count = 0;
      for (std::size_t e = d + 175; e <= d + 185; ++e)
        count += counts[e % 180];
      if (count > best_count)
        best = d, best_count = count;
    }
    const double angle = (double(best) + .5) * CGAL_PI / 180.;
    return {std::cos(angle), std::sin(angle), 0.};
  }

public:
  /// \param thickness of the slab that holds a wall with its reliefs
  Wall_frame(const Points& points, double thickness)
  {
    const Vectors normals = pca_normals(points);
    m_out = most_frequent_level_direction(normals);
    // of the parallel walls, the slab with the most points that face it
    std::map<long, std::vector<std::size_t>> slabs;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (std::abs(normals[i] * m_out) > .95)
        for (const long half : {0, 1}) { // they overlap by half
          const double shift = half == 0 ? 0. : thickness / 2.;
          const double depth = (points[i] - CGAL::ORIGIN) * m_out - shift;
          slabs[2 * std::lround(depth / thickness) + half].push_back(i);
        }
    const auto best =
        std::max_element(slabs.begin(), slabs.end(), [](const auto& a, const auto& b) {
          return a.second.size() < b.second.size();
        });
    fit(points, best->second);
    const Point_3 middle = CGAL::centroid(points.begin(), points.end(), CGAL::Dimension_tag<0>());
    if ((m_origin - middle) * m_out < 0.)
      m_out = -m_out;
    m_along = CGAL::cross_product(Vector_3(0., 0., 1.), m_out);
  }

  Point_3 operator()(const Point_3& p) const
  {
    const Vector_3 d = p - m_origin;
    return {d * m_along, d.z(), d * m_out};
  }
  Points operator()(Points points) const
  {
    std::transform(points.begin(), points.end(), points.begin(),
                   [&](const Point_3& p) { return (*this)(p); });
    return points;
  }

private:
  /// Turns the direction to that of the line which fits the points from above
  void fit(const Points& points, const std::vector<std::size_t>& wall)
  {
    const Vector_3 along(-m_out.y(), m_out.x(), 0.);
    double n = 0., u_sum = 0., w_sum = 0., uu = 0., uw = 0., z_sum = 0.;
    for (const std::size_t i : wall) {
      const Vector_3 d = points[i] - CGAL::ORIGIN;
      const double u = d * along, w = d * m_out;
      n += 1.;
      u_sum += u;
      w_sum += w;
      uu += u * u;
      uw += u * w;
      z_sum += d.z();
    }
    const double slope = (uw - u_sum * w_sum / n) / (uu - u_sum * u_sum / n);
    m_origin = CGAL::ORIGIN + u_sum / n * along + w_sum / n * m_out + Vector_3(0., 0., z_sum / n);
    m_out = (m_out - slope * along) / std::sqrt(1. + slope * slope);
  }
};

} // namespace comparison

#endif // POINT_SET_FLOW_BENCHMARK_WALL_FRAME_H
