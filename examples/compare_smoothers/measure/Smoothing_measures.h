// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef COMPARISON_SMOOTHING_MEASURES_H
#define COMPARISON_SMOOTHING_MEASURES_H

#include "Nearest_points.h"
#include "Numbered_points.h"

#include <algorithm>
#include <cmath>

namespace comparison {

/// What is measured of smoothed points. Lengths are in the unit of the points, angles in degrees.
/// All measures run in one thread, so that nothing of theirs is in the way of a process that forks.

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Mean, root mean square and maximum of absolute values
class Error_sum {
  double m_sum = 0., m_squares = 0., m_max = 0.;
  std::size_t m_n = 0;

public:
  void add(double error)
  {
    m_sum += error;
    m_squares += error * error;
    m_max = (std::max)(m_max, std::abs(error));
    ++m_n;
  }
  double mean() const { return m_n == 0 ? unknown : m_sum / double(m_n); }
  double mean_square() const { return m_n == 0 ? unknown : m_squares / double(m_n); }
  double rms() const { return std::sqrt(mean_square()); }
  double max() const { return m_n == 0 ? unknown : m_max; }
};

/// Distances to the surface: of all points, of those near sharp edges, and with their sign, whose
/// mean is the shrinkage if it is negative.
struct Surface_errors {
  Error_sum all, near_edges;
  std::vector<double> signed_distances;
  Vectors true_normals; ///< of the surface where it is closest

  /// `near_edge` of each point; if it is empty, there is an edge near where one is closer than
  /// `edge_distance` to the smoothed point
  Surface_errors(const Points& points, const Surface& surface, const std::vector<char>& near_edge,
                 double edge_distance = 0.)
  {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Surface_point closest = surface.closest(points[i]);
      all.add(closest.signed_distance);
      signed_distances.push_back(closest.signed_distance);
      true_normals.push_back(closest.normal);
      if (near_edge.empty() ? surface.distance_to_sharp_edge(closest.point) <= edge_distance
                            : near_edge[i])
        near_edges.add(closest.signed_distance);
    }
  }
};

/// The mean of the squared distances from each point to the nearest one of others
inline double mean_squared_nearest_distance(const Points& points, const Points& others)
{
  const Nearest_points nearest(others);
  double sum = 0.;
  for (const Point_3& p : points)
    sum += nearest(p).second;
  return sum / double(points.size());
}

/// Two-way squared Chamfer distance of the learned denoisers (Luo and Hu 2021, and others)
inline double chamfer_distance(const Points& points, const Points& clean)
{
  return mean_squared_nearest_distance(points, clean) +
         mean_squared_nearest_distance(clean, points);
}

/// rms movement, and rms movement within the surface: without its part along the true normal where
/// the point came from
inline double movement(const Points& from, const Points& to)
{
  Error_sum sum;
  for (std::size_t i = 0; i < to.size(); ++i)
    sum.add(std::sqrt(CGAL::squared_distance(from[i], to[i])));
  return sum.rms();
}
inline double tangential_drift(const Points& from, const Points& to, const Vectors& normals)
{
  Error_sum sum;
  for (std::size_t i = 0; i < to.size(); ++i) {
    const Vector_3 d = to[i] - from[i];
    sum.add(std::sqrt((d - (d * normals[i]) * normals[i]).squared_length()));
  }
  return sum.rms();
}

/// Mean distance to the nearest other point, and its coefficient of variation: 0 for a lattice,
/// about 0.5 for random points
struct Spacing {
  double mean, variation;
};
inline Spacing spacing(const Points& points)
{
  const Nearest_points nearest(points);
  Error_sum sum;
  for (const Point_3& p : points)
    sum.add(std::sqrt(nearest(p, 2).back().second));
  const double m = sum.mean();
  return {m, std::sqrt((std::max)(0., sum.mean_square() - m * m)) / m};
}

/// Mean angle between lines along the normals; their sides do not matter
inline double normal_error(const Vectors& normals, const Vectors& true_normals)
{
  Error_sum sum;
  for (std::size_t i = 0; i < normals.size(); ++i)
    sum.add(std::atan2(std::sqrt(CGAL::cross_product(normals[i], true_normals[i]).squared_length()),
                       std::abs(normals[i] * true_normals[i])) *
            180. / CGAL_PI);
  return sum.mean();
}

/// PCA normals with 18 neighbors
inline Vectors pca_normals(const Points& points)
{
  return normals_in_order(with_normals<CGAL::Sequential_tag>(points, false));
}

/// rms distance of the points to the plane of their 18 nearest neighbors: through the centroid, across
/// the PCA normal. Without a truth this is what is left of the noise, and curvature.
inline double roughness(const Points& points)
{
  const Vectors normals = pca_normals(points);
  const Nearest_points nearest(points);
  Error_sum sum;
  for (std::size_t i = 0; i < points.size(); ++i) {
    Vector_3 to_centroid = CGAL::NULL_VECTOR;
    const auto neighbors = nearest(points[i], 19); // the point itself, too
    for (const auto& neighbor : neighbors)
      to_centroid += (points[neighbor.first] - points[i]) / double(neighbors.size());
    sum.add(to_centroid * normals[i]);
  }
  return sum.rms();
}

} // namespace comparison

#endif // COMPARISON_SMOOTHING_MEASURES_H
