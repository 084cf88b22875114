// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_NOISE_SCALE_SAMPLES_H
#define CGAL_POINT_SET_FLOW_INTERNAL_NOISE_SCALE_SAMPLES_H

#include <CGAL/Point_set_flow/Curvature_defaults.h>
#include <CGAL/Point_set_flow/internal/fitting/Covariance_3.h>
#include <CGAL/Point_set_flow/internal/neighbors/Neighbor_tree.h>
#include <CGAL/Point_set_flow/internal/parallel/Loops.h>
#include <CGAL/Point_set_flow/internal/parallel/sort_range.h>
#include <CGAL/number_type_config.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// The deviation of points from a quadric fitted to them by least squares, with the degrees of
/// freedom of the quadric taken off: the noise, if the surface is smooth at this size.
/// \param neighbors the first entry is the point itself
inline double quadric_residual(const Array<Point_3>& points,
                               const std::vector<std::uint32_t>& neighbors, double radius)
{
  const Neighborhood_3 neighborhood(points.data(), neighbors[0], neighbors.data() + 1,
                                    neighbors.size() - 1, radius, 1.);
  const Vector_3 normal = smallest_eigenpair(Covariance_3(neighborhood)).vector;
  const Vector_3 axis = std::abs(normal.x()) < .6 ? Vector_3(1., 0., 0.) : Vector_3(0., 1., 0.);
  Vector_3 e1 = cross_product(normal, axis);
  e1 = e1 / std::sqrt(e1.squared_length());
  const Vector_3 e2 = cross_product(normal, e1);

  const Eigen::Index m = Eigen::Index(neighbors.size());
  Eigen::Matrix<double, Eigen::Dynamic, 6> terms(m, 6);
  Eigen::VectorXd height(m);
  for (Eigen::Index j = 0; j < m; ++j) {
    const Vector_3 d = (points[neighbors[std::size_t(j)]] - neighborhood.center()) / radius;
    const double x = d * e1, y = d * e2;
    terms.row(j) << 1., x, y, x * x, x * y, y * y;
    height[j] = d * normal;
  }
  // the normal equations, which are as good here: within a neighborhood the terms are about 1
  const Eigen::Matrix<double, 6, 6> products = terms.transpose() * terms;
  const Eigen::Matrix<double, 6, 1> heights = terms.transpose() * height;
  const Eigen::VectorXd rest = height - terms * products.colPivHouseholderQr().solve(heights);
  return radius * std::sqrt(rest.squaredNorm() / double(m - 6));
}

inline double median(std::vector<double>& values)
{
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// About 1,000 points spread evenly over the ranks of the distance to the centroid: the same ones
/// however the points are moved, turned, scaled or numbered.
template <typename ConcurrencyTag>
std::vector<std::uint32_t> sample(const Array<Point_3>& points)
{
  Vector_3 mean(0., 0., 0.);
  for (const Point_3& p : points)
    mean = mean + (p - ORIGIN);
  const Point_3 centroid = ORIGIN + mean / double(points.size());

  std::vector<std::pair<double, std::uint32_t>> ranked(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    ranked[i] = {squared_distance(points[i], centroid), static_cast<std::uint32_t>(i)};
  sort_range<ConcurrencyTag>(ranked.begin(), ranked.end());

  const std::size_t count = (std::min)(points.size(), std::size_t(1000));
  std::vector<std::uint32_t> chosen(count);
  for (std::size_t i = 0; i < count; ++i)
    chosen[i] = ranked[i * points.size() / count].second;
  return chosen;
}

/// The noise and the spacing of a point set, and the noise at some of its points.
struct Sampled_scale {
  double noise = 0., spacing = 0.;
  std::vector<std::uint32_t> sites; // the samples
  // where they are, and the noise there; empty where there are too few points for quadrics
  Array<Point_3> points;
  std::vector<double> noises;
};

/// Finds the noise and the spacing of a point set.
template <typename ConcurrencyTag>
Sampled_scale find_scale(ConcurrencyTag, const Neighbor_tree& tree, Progress& progress, double work)
{
  Sampled_scale scale;
  const Array<Point_3>& points = tree.points();
  scale.sites = sample<ConcurrencyTag>(points);
  progress.advance(0.);
  std::vector<std::size_t> sizes = {12, 24, 48, 96, 192};
  while (!sizes.empty() && sizes.back() >= points.size())
    sizes.pop_back();
  if (sizes.empty())
    return scale;

  const std::vector<std::uint32_t>& chosen = scale.sites;
  std::vector<std::vector<double>> noises(sizes.size(), std::vector<double>(chosen.size()));
  std::vector<std::vector<double>> radii = noises;
  const auto measure = [&](std::size_t begin, std::size_t end) {
    Neighbor_tree::Query query(tree, sizes.back());
    std::vector<std::uint32_t> neighbors;
    for (std::size_t i = begin; i < end; ++i) {
      const std::vector<Neighbor_tree::Neighbor>& found = query(chosen[i]);
      neighbors.assign(1, chosen[i]);
      for (std::size_t s = 0; s < sizes.size(); ++s) {
        while (neighbors.size() <= sizes[s])
          neighbors.push_back(found[neighbors.size() - 1].index);
        radii[s][i] = std::sqrt(found[sizes[s] - 1].squared_distance);
        noises[s][i] = radii[s][i] > 0. ? quadric_residual(points, neighbors, radii[s][i]) : 0.;
      }
    }
  };
  for_each_block<ConcurrencyTag>(chosen.size(), progress, work, measure, 16);

  // One small size can not tell noise from structure once the noise exceeds the spacing: take
  // the first size whose neighborhoods are large against the noise found in them. First for each
  // sample by itself ...
  const double large = 4.;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    std::size_t s = 0;
    while (s + 1 < sizes.size() && radii[s][i] < large * noises[s][i])
      ++s;
    scale.points.push_back(points[chosen[i]]);
    scale.noises.push_back(noises[s][i]);
  }
  // ... then for all of them
  std::size_t s = 0;
  double radius = median(radii[0]);
  scale.noise = median(noises[0]);
  while (s + 1 < sizes.size() && (radius < large * scale.noise || sizes[s] < 48)) {
    const bool wide_enough = radius >= large * scale.noise;
    radius = median(radii[++s]);
    if (!wide_enough)
      scale.noise = median(noises[s]);
  }
  scale.spacing = radius * std::sqrt(CGAL_PI / double(sizes[s]));
  return scale;
}

/// The number of neighbors for a noise in multiples of the spacing
inline unsigned int neighborhood_size(const Curvature_defaults& defaults, double noise)
{
  const double size = defaults.size_factor * std::pow(noise, defaults.size_exponent);
  return static_cast<unsigned int>(std::round(
      (std::min)((std::max)(size, double(defaults.smallest_size)), double(defaults.largest_size))));
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_NOISE_SCALE_SAMPLES_H
