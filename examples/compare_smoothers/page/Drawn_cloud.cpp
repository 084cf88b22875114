// SPDX-License-Identifier: GPL-3.0-or-later
#include "Drawn_cloud.h"

#include "measure/Nearest_points.h"
#include "measure/Smoothers.h"

#include <CGAL/Eigen_diagonalize_traits.h>
#include <CGAL/balanced_flow_smooth_point_set.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace comparison {

namespace {

/// The numbers of the points that are drawn, in random order if there are more than `most`
std::vector<std::size_t> choose_drawn(std::size_t n, std::size_t most)
{
  std::vector<std::size_t> chosen = numbers(n);
  if (n > most) {
    std::shuffle(chosen.begin(), chosen.end(), std::mt19937(1));
    chosen.resize(most);
  }
  return chosen;
}

/// How much of a feature each point is: `feature_strength_map` of this package, of the points as
/// they are. Neighborhoods are the same for all clouds, rather than what suits their noise.
/// In one thread: there may be processes to fork after it.
std::vector<double> feature_strengths(Points points)
{
  std::vector<double> strengths(points.size());
  std::vector<std::size_t> indices = numbers(points.size());
  CGAL::balanced_flow_smooth_point_set<CGAL::Sequential_tag>(
      indices, 24,
      CGAL::parameters::feature_strength_map(CGAL::make_property_map(strengths))
          .filter_width(.6)
          .point_map(CGAL::make_property_map(points))
          .number_of_iterations(0));
  return strengths;
}

} // namespace

Drawn_cloud make_drawn_cloud(const Points& points, const std::vector<double>& errors,
                             std::size_t most)
{
  typedef CGAL::Eigen_diagonalize_traits<double, 3> Diagonalize;
  Drawn_cloud cloud;
  const Nearest_points nearest(points);
  const std::vector<double> strengths = feature_strengths(points);
  std::vector<double> reaches;
  for (const std::size_t i : choose_drawn(points.size(), most)) {
    const auto neighbors = nearest(points[i], 19); // the point itself, too
    Vector_3 centroid = CGAL::NULL_VECTOR;
    for (const auto& neighbor : neighbors)
      centroid += (points[neighbor.first] - points[i]) / double(neighbors.size());
    Diagonalize::Covariance_matrix covariance = {0., 0., 0., 0., 0., 0.};
    for (const auto& neighbor : neighbors) {
      const Vector_3 d = points[neighbor.first] - points[i] - centroid;
      std::size_t entry = 0;
      for (int row = 0; row < 3; ++row)
        for (int column = row; column < 3; ++column)
          covariance[entry++] += d[row] * d[column];
    }
    Diagonalize::Vector values;
    Diagonalize::Matrix vectors;
    Diagonalize::diagonalize_selfadjoint_covariance_matrix(covariance, values, vectors);
    const double sum = values[0] + values[1] + values[2];

    cloud.points.push_back(points[i]);
    cloud.normals.emplace_back(vectors[0], vectors[1], vectors[2]);
    cloud.variations.push_back(sum > 0. ? (std::max)(0., values[0]) / sum : 0.);
    cloud.strengths.push_back(strengths[i]);
    if (!errors.empty())
      cloud.errors.push_back(errors[i]);
    reaches.push_back(neighbors[(std::min)(std::size_t(6), neighbors.size() - 1)].second);
  }
  const auto middle = reaches.begin() + std::ptrdiff_t(reaches.size() / 2);
  std::nth_element(reaches.begin(), middle, reaches.end());
  cloud.spacing = std::sqrt(*middle * double(points.size()) / double(cloud.points.size()));
  return cloud;
}

} // namespace comparison
