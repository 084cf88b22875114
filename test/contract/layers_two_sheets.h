// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_TEST_LAYERS_TWO_SHEETS_H
#define POINT_SET_FLOW_TEST_LAYERS_TWO_SHEETS_H

#include "shapes.h"

#include <CGAL/balanced_flow_smooth_point_set.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <random>
#include <vector>

namespace layers {

namespace np = CGAL::parameters;
using shapes::Points;
typedef CGAL::Sequential_tag Sequential;
typedef std::vector<shapes::Vector_3> Normals;

const shapes::Vector_3 unknown(0., 0., 0.);

const double sigma = .02; // half of the spacing of a sheet

/// Points with normals that are given, and where they would be without noise
struct Scan {
  Points points, truth;
  Normals normals;

  std::size_t size() const { return points.size(); }

  template <typename Tag = Sequential>
  Points smoothed(Normals given, unsigned int block_size = 1000000) const
  {
    Points result = points;
    std::vector<std::size_t> indices(size());
    std::iota(indices.begin(), indices.end(), std::size_t(0));
    CGAL::balanced_flow_smooth_point_set<Tag>(indices,
                                              np::block_size(block_size)
                                                  .point_map(CGAL::make_property_map(result))
                                                  .normal_map(CGAL::make_property_map(given)));
    return result;
  }

  Points smoothed_without_normals() const
  {
    Points result = points;
    CGAL::balanced_flow_smooth_point_set<Sequential>(result);
    return result;
  }

  /// The mean of a function of a point and its number, over points of one layer and far from the border
  template <typename Function>
  double mean(const Points& result, bool is_up, const Function& function) const
  {
    double sum = 0., count = 0.;
    for (std::size_t i = 0; i < size(); ++i)
      if ((normals[i].z() > 0.) == is_up && std::abs(truth[i].x()) < .7 &&
          std::abs(truth[i].y()) < .7) {
        sum += function(result[i], i);
        count += 1.;
      }
    return sum / count;
  }
};

/// Two square sheets, one above the other
/// \param side of the lower one; that of the upper one is 1
inline Scan two_sheets(double separation, double side, unsigned int seed = 1, double noise = sigma)
{
  Scan scan;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> jitter(.1, .9);
  const int m = 50;
  for (const double sign : {-1., 1.})
    for (int i = 0; i < m; ++i)
      for (int j = 0; j < m; ++j) {
        const double x = 2. * (i + jitter(random)) / m - 1., y = 2. * (j + jitter(random)) / m - 1.;
        scan.truth.emplace_back(x, y, .5 * sign * separation);
        scan.normals.emplace_back(0., 0., sign > 0. ? 1. : side);
      }
  scan.points = scan.truth;
  shapes::add_noise(scan.points, noise, seed);
  return scan;
}

inline Normals turned(Normals normals)
{
  for (auto& n : normals)
    n = -n;
  return normals;
}

inline Normals at_random(Normals normals)
{
  std::mt19937 random(7);
  for (auto& n : normals)
    if (random() % 2)
      n = -n;
  return normals;
}

inline double approach(const Scan& scan, const Points& result, double separation)
{
  const auto error = [&](const shapes::Point_3& p, std::size_t i) {
    return p.z() - scan.truth[i].z();
  };
  return (std::max)(std::abs(scan.mean(result, true, error)),
                    std::abs(scan.mean(result, false, error))) /
         separation;
}

/// The rms distance of the points from where they should be
inline double deviation(const Scan& scan, const Points& result)
{
  const auto squared = [&](const shapes::Point_3& p, std::size_t i) {
    return (p.z() - scan.truth[i].z()) * (p.z() - scan.truth[i].z());
  };
  return std::sqrt(.5 * (scan.mean(result, true, squared) + scan.mean(result, false, squared)));
}

} // namespace layers

#endif // POINT_SET_FLOW_TEST_LAYERS_TWO_SHEETS_H
