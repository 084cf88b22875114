// SPDX-License-Identifier: GPL-3.0-or-later
// The only file of this test that compiles the smoothing with normals
#include "Two_sheets.h"

#include <CGAL/balanced_flow_smooth_point_set.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace layers {

namespace {

namespace np = CGAL::parameters;

template <typename Tag>
Points smooth(const Scan& scan, Normals normals, unsigned int block_size)
{
  Points result = scan.points;
  std::vector<std::size_t> indices(scan.size());
  std::iota(indices.begin(), indices.end(), std::size_t(0));
  CGAL::balanced_flow_smooth_point_set<Tag>(indices,
                                            np::block_size(block_size)
                                                .point_map(CGAL::make_property_map(result))
                                                .normal_map(CGAL::make_property_map(normals)));
  return result;
}

} // namespace

Points Scan::smoothed(const Normals& given, unsigned int block_size) const
{
  return smooth<CGAL::Sequential_tag>(*this, given, block_size);
}

Points Scan::smoothed_in_parallel(const Normals& given) const
{
  return smooth<CGAL::Parallel_if_available_tag>(*this, given, 1000000);
}

Points Scan::smoothed_without_normals() const
{
  Points result = points;
  CGAL::balanced_flow_smooth_point_set<CGAL::Sequential_tag>(result);
  return result;
}

Scan two_sheets(double separation, double side, unsigned int seed, double noise)
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

Normals turned(Normals normals)
{
  for (auto& n : normals)
    n = -n;
  return normals;
}

Normals at_random(Normals normals)
{
  std::mt19937 random(7);
  for (auto& n : normals)
    if (random() % 2)
      n = -n;
  return normals;
}

double approach(const Scan& scan, const Points& result, double separation)
{
  const auto error = [&](const shapes::Point_3& p, std::size_t i) {
    return p.z() - scan.truth[i].z();
  };
  return (std::max)(std::abs(scan.mean(result, true, error)),
                    std::abs(scan.mean(result, false, error))) /
         separation;
}

double deviation(const Scan& scan, const Points& result)
{
  const auto squared = [&](const shapes::Point_3& p, std::size_t i) {
    return (p.z() - scan.truth[i].z()) * (p.z() - scan.truth[i].z());
  };
  return std::sqrt(.5 * (scan.mean(result, true, squared) + scan.mean(result, false, squared)));
}

} // namespace layers
