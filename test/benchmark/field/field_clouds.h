// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_BENCHMARK_FIELD_CLOUDS_H
#define POINT_SET_FLOW_BENCHMARK_FIELD_CLOUDS_H

#include "Cloud_maker.h"

namespace comparison {

/// Clouds of terrain, with patterns and noise as sensors have them. The spacing is 1 in the mean.
namespace field_clouds {

/// Airborne laser scanning: a zigzag of lines across the track, closer at its turns; noise of
/// heights, in spacings.
inline Test_cloud airborne(Cloud_maker make, double noise)
{
  const auto surface = make.terrain();
  const double sigma = noise * make.variation.noise,
               half = std::sqrt(double(make.variation.n)) / 2.;
  Test_cloud cloud;
  cloud.name = "airborne terrain";
  cloud.surface = surface;
  const std::size_t per_line = std::size_t(2. * half);
  for (std::size_t i = 0; i < make.variation.n; ++i) {
    const double line = double(i) / double(per_line);
    const double mirror = std::cos(CGAL_PI * line); // swings
    const double x = half * std::asin(.95 * mirror) / std::asin(.95) + .2 * make.uniform(-1., 1.);
    const double y = line - half + .2 * make.uniform(-1., 1.);
    cloud.points.emplace_back(x, y, surface->height(x, y) + make.normal(sigma));
  }
  return cloud;
}

/// Three times the same points, which differ by rounding only
inline Test_cloud merged_twice(Cloud_maker make)
{
  const auto surface = make.terrain();
  Test_cloud cloud;
  cloud.name = "copies 1e-6 away";
  cloud.surface = surface;
  make.square(make.variation.n / 3, .8, [&](double x, double y) {
    const Point_3 p = surface->point(x, y) + make.isotropic(.35 * make.variation.noise);
    cloud.points.push_back(p);
    for (int copy = 0; copy < 2; ++copy)
      cloud.points.push_back(p + make.isotropic(1e-6 / std::sqrt(3.)));
  });
  return cloud;
}

/// 15 frames of a depth camera that stands still: 15 depths on the ray of each pixel
inline Test_cloud depth_frames(Cloud_maker make)
{
  const auto surface = make.terrain();
  const Point_3 camera(0., 0., 1.5 * std::sqrt(double(make.variation.n) / 15.) + 10.);
  Test_cloud cloud;
  cloud.name = "15 depth frames";
  cloud.surface = surface;
  make.square(make.variation.n / 15, 0., [&](double x, double y) {
    const Point_3 p = surface->point(x, y);
    const Vector_3 ray = (p - camera) / std::sqrt(CGAL::squared_distance(p, camera));
    for (int frame = 0; frame < 15; ++frame)
      cloud.points.push_back(p + make.normal(.3 * make.variation.noise) * ray);
  });
  return cloud;
}

/// Profiles of a line laser, which lie 16 times as far apart as the points on them
inline Test_cloud laser_profiles(Cloud_maker make)
{
  const auto surface = make.terrain(60.);
  const double half = std::sqrt(double(make.variation.n)) / 2.;
  Test_cloud cloud;
  cloud.name = "laser profiles";
  cloud.surface = surface;
  make.grid(-half, half, -half, half, 4., .25, .1, [&](double x, double y) {
    cloud.points.emplace_back(x, y,
                              surface->height(x, y) + make.normal(.05 * make.variation.noise));
  });
  return cloud;
}

/// Heights in steps of three standard deviations of their noise
inline Test_cloud rounded_heights(Cloud_maker make)
{
  const auto surface = make.terrain();
  const double sigma = .03 * make.variation.noise;
  Test_cloud cloud;
  cloud.name = "rounded heights";
  cloud.surface = surface;
  make.square(make.variation.n, .8, [&](double x, double y) {
    const double z = surface->height(x, y) + make.normal(sigma);
    cloud.points.emplace_back(x, y, 3. * sigma * std::round(z / (3. * sigma)));
  });
  return cloud;
}

/// Ground with leaves above it, in crowns, which take a quarter of the points. Only the points of the
/// ground count for the error.
inline Test_cloud below_leaves(Cloud_maker make)
{
  const auto surface = make.terrain();
  const double half = std::sqrt(double(make.variation.n)) / 2.;
  Test_cloud cloud;
  cloud.name = "ground below leaves";
  cloud.surface = surface;
  std::vector<std::pair<double, double>> trees;
  for (std::size_t i = 0; i < make.variation.n / 200; ++i) {
    const double x = make.uniform(-half, half);
    trees.emplace_back(x, make.uniform(-half, half));
  }
  make.square(make.variation.n, .8, [&](double x, double y) {
    const bool leaf = make.uniform(0., 1.) < .25;
    if (leaf) { // instead of the ground below it, somewhere in a crown
      const auto& tree = trees[std::size_t(make.uniform(0., double(trees.size())))];
      x = tree.first + make.normal(3.);
      y = tree.second + make.normal(3.);
    }
    const double z = leaf ? make.uniform(3., 9.) : make.normal(.05 * make.variation.noise);
    cloud.points.emplace_back(x, y, surface->height(x, y) + z);
    cloud.belongs.push_back(!leaf);
  });
  return cloud;
}

/// Two scans of the same ground, .4 apart by their registration; the truth is in the middle. The
/// normals are those of a scanner that knows its side.
inline Test_cloud registered_scans(Cloud_maker make)
{
  const auto surface = make.terrain();
  Test_cloud cloud;
  cloud.name = "two registered scans";
  cloud.surface = surface;
  const double half = std::sqrt(double(make.variation.n)) / 2.;
  for (const double side : {-.2, .2})
    for (std::size_t i = 0; i < make.variation.n / 2; ++i) {
      const double x = make.uniform(-half, half), y = make.uniform(-half, half);
      const Vector_3 n = surface->normal(x, y);
      cloud.points.push_back(surface->point(x, y) + Vector_3(0., 0., side) +
                             make.isotropic(.05 * make.variation.noise));
      const Vector_3 rough = n + make.isotropic(.1);
      cloud.normals.push_back(rough / std::sqrt(rough.squared_length()));
    }
  return cloud;
}

} // namespace field_clouds

} // namespace comparison

#endif // POINT_SET_FLOW_BENCHMARK_FIELD_CLOUDS_H
