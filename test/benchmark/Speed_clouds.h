// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_BENCHMARK_SPEED_CLOUDS_H
#define POINT_SET_FLOW_BENCHMARK_SPEED_CLOUDS_H

#include "measure/Surface.h"

#include <CGAL/hilbert_sort.h>
#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <string>

namespace comparison {

/// The radius of a sphere with bumps, in a direction
inline double bumpy_radius(const Vector_3& direction)
{
  return 1. +
         .05 * std::sin(7. * direction.x()) * std::cos(5. * direction.y() + 2. * direction.z());
}

/// The rms distance of points from the sphere with bumps, along its radius, in spacings
inline double rms_error(const Points& points)
{
  double squares = 0.;
  for (const Point_3& p : points) {
    const Vector_3 v = p - CGAL::ORIGIN;
    const double length = std::sqrt(v.squared_length());
    const double distance = length - bumpy_radius(v / length);
    squares += distance * distance;
  }
  return std::sqrt(squares / (4. * CGAL_PI)); // the spacing is that of an even sphere
}

/// A sphere with bumps and noise of half a spacing: `uniform` is spaced evenly, `scan` comes in lines
/// that are ten times as far from each other as the points on them.
inline Points bumpy_sphere(const std::string& sampling, std::size_t n)
{
  std::mt19937 random(1);
  const double spacing = std::sqrt(4. * CGAL_PI / double(n));
  std::normal_distribution<double> noise(0., .5 * spacing);
  const double golden = CGAL_PI * (3. - std::sqrt(5.));
  const double lines = std::sqrt(double(n) / 10.);
  Points points;
  points.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double at = (double(i) + .5) / double(n), z = 1. - 2. * at;
    const double turn = sampling == "scan" ? 2. * CGAL_PI * std::fmod(at * lines, 1.)
                                           : std::fmod(golden * double(i), 2. * CGAL_PI);
    const double height = sampling == "scan" ? 1. - 2. * (std::floor(at * lines) + .5) / lines : z;
    const double around = std::sqrt((std::max)(0., 1. - height * height));
    const Vector_3 direction(around * std::cos(turn), around * std::sin(turn), height);
    points.push_back(CGAL::ORIGIN + bumpy_radius(direction) * direction +
                     Vector_3(noise(random), noise(random), noise(random)));
  }
  return points;
}

/// Clouds that make careless trees and searches slow
inline Points difficult_cloud(const std::string& kind, std::size_t n)
{
  if (kind == "identical points")
    return Points(n, Point_3(1., 2., 3.));
  Points points;
  std::mt19937 random(1);
  const auto fill = [&](const auto& point) {
    while (points.size() < n)
      points.push_back(point());
  };
  if (kind == "points on a line") {
    std::uniform_real_distribution<double> along(0., 1.);
    fill([&] {
      const double t = along(random);
      return Point_3(t, 2. * t, 3. * t);
    });
    return points;
  }
  std::uniform_real_distribution<double> u(-1., 1.);
  if (kind == "points over 40 decades") {
    fill([&] {
      const double size = std::pow(10., 20. * u(random));
      return Point_3(size * u(random), size * u(random), size * u(random));
    });
    return points;
  }
  if (kind == "a plane and a point far away") {
    fill([&] { return Point_3(0., u(random), u(random)); });
    points.back() = Point_3(1e9, 0., 0.);
    return points;
  }
  if (kind == "each point ten times") {
    const Points once = bumpy_sphere("uniform", n / 10);
    for (int i = 0; i < 10; ++i)
      points.insert(points.end(), once.begin(), once.end());
    return points;
  }
  points = bumpy_sphere("uniform", n);
  if (kind == "a point far away")
    points.back() = Point_3(1e6, 0., 0.);
  else if (kind != "ordinary")
    throw std::invalid_argument("no cloud is called " + kind);
  return points;
}

/// The order in which the points come: of files, or of a map.
inline void put_in_order(Points& points, const std::string& order)
{
  if (order == "unordered")
    std::shuffle(points.begin(), points.end(), std::mt19937(2));
  else
    CGAL::hilbert_sort(points.begin(), points.end());
}

} // namespace comparison

#endif // POINT_SET_FLOW_BENCHMARK_SPEED_CLOUDS_H
