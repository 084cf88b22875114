// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_BENCHMARK_RANDOM_SHAPES_H
#define POINT_SET_FLOW_BENCHMARK_RANDOM_SHAPES_H

#include "Benchmark_shapes.h"

#include <cmath>
#include <optional>
#include <random>
#include <utility>
#include <vector>

namespace comparison {

/// Generated surfaces with random proportions
class Random_shapes {
  std::mt19937& m_random;

  double uniform(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(m_random);
  }

  /// Points on a grid of parameters from 0 to 1, in quadrangles
  template <typename Place>
  static std::optional<Mesh> grid(std::size_t m, const Place& place)
  {
    Points points;
    Polygons faces;
    for (std::size_t i = 0; i <= m; ++i)
      for (std::size_t j = 0; j <= m; ++j) {
        points.push_back(place(double(i) / double(m), double(j) / double(m)));
        const std::size_t v = points.size() - 1, w = v - m - 1;
        if (i > 0 && j > 0)
          faces.push_back({w - 1, v - 1, v, w});
      }
    Unit_sphere_map::of(points).apply(points);
    return make_mesh(points, faces);
  }

public:
  explicit Random_shapes(std::mt19937& random) : m_random(random) {}

  /// A prism over a polygon that is star-shaped around the origin: edges of all angles
  std::optional<Mesh> prism_of_random_polygon()
  {
    const int corners = int(uniform(3., 11.));
    std::vector<std::pair<double, double>> polygon;
    for (int i = 0; i < corners; ++i) {
      const double angle = 2. * CGAL_PI * (i + uniform(-.3, .3)) / corners, r = uniform(.4, 1.);
      polygon.emplace_back(r * std::cos(angle), r * std::sin(angle));
    }
    return prism(polygon, std::pow(10., uniform(-1., .3)));
  }
  std::optional<Mesh> stairs()
  {
    const int steps = int(uniform(2., 7.));
    const double rise = uniform(.05, .4);
    std::vector<std::pair<double, double>> polygon = {{0., 0.}, {1., 0.}};
    for (int i = 0; i < steps; ++i) {
      polygon.emplace_back(1. - double(i) / steps, rise * (i + 1));
      polygon.emplace_back(1. - double(i + 1) / steps, rise * (i + 1));
    }
    return prism(polygon, uniform(.3, 1.5));
  }
  std::optional<Mesh> tube()
  {
    const double r = std::pow(10., uniform(-1.3, -.4)), wobble = uniform(0., .3);
    const int waves = int(uniform(1., 6.));
    return grid(160, [=](double s, double t) {
      const double u = 2. * CGAL_PI * s, v = 2. * CGAL_PI * t;
      const double local = r * (1. + wobble * std::sin(waves * u));
      return Point_3((1. + local * std::cos(v)) * std::cos(u),
                     (1. + local * std::cos(v)) * std::sin(u),
                     local * std::sin(v) + wobble * std::cos(2. * u));
    });
  }
  std::optional<Mesh> bumpy_sphere()
  {
    const double height = std::pow(10., uniform(-2.5, -.7));
    const int m = int(uniform(2., 14.)), l = int(uniform(2., 14.));
    return grid(160, [=](double s, double t) {
      const double u = 2. * CGAL_PI * s, v = CGAL_PI * (.001 + .998 * t);
      const double r = 1. + height * std::sin(m * u) * std::sin(l * v) * std::sin(v);
      return Point_3(r * std::sin(v) * std::cos(u), r * std::sin(v) * std::sin(u), r * std::cos(v));
    });
  }
  std::optional<Mesh> random_waves()
  {
    double a[4], kx[4], ky[4], phase[4];
    for (int i = 0; i < 4; ++i) {
      const double k = std::pow(10., uniform(.3, 1.4)), direction = uniform(0., CGAL_PI);
      a[i] = uniform(0., .5) / k, kx[i] = k * std::cos(direction), ky[i] = k * std::sin(direction);
      phase[i] = uniform(0., 6.);
    }
    const bool creased = uniform(0., 1.) < .3;
    return grid(160, [=](double s, double t) {
      double z = 0.;
      for (int i = 0; i < 4; ++i)
        z += a[i] * std::sin(kx[i] * s + ky[i] * t + phase[i]);
      return Point_3(s, t, creased ? std::abs(z) : z);
    });
  }
  /// Two surfaces above each other at a distance that varies: a thin wall without its rim
  std::optional<Mesh> wall()
  {
    const double thickness = std::pow(10., uniform(-2., -.8)), wedge = uniform(0., .8);
    const double k = uniform(0., 8.), l = uniform(0., 8.), height = uniform(0., .15),
                 bend = uniform(0., .6);
    const std::size_t m = 100;
    Points points;
    Polygons faces;
    for (const double side : {-.5, .5})
      for (std::size_t i = 0; i <= m; ++i)
        for (std::size_t j = 0; j <= m; ++j) {
          const double s = double(i) / double(m), t = double(j) / double(m);
          const double z = height * std::sin(k * s) * std::cos(l * t) + bend * s * s;
          points.emplace_back(s, t, z + side * thickness * (1. - wedge * t));
          const std::size_t v = points.size() - 1, w = v - m - 1;
          if (i > 0 && j > 0)
            faces.push_back(side > 0. ? std::vector<std::size_t>{w - 1, v - 1, v, w}
                                      : std::vector<std::size_t>{w, v, v - 1, w - 1});
        }
    Unit_sphere_map::of(points).apply(points);
    return make_mesh(points, faces);
  }
  std::optional<Mesh> operator()()
  {
    switch (std::uniform_int_distribution<int>(0, 8)(m_random)) {
    case 7:
    case 8:
      return wall();
    case 0:
      return prism_of_random_polygon();
    case 1:
      return stairs();
    case 2:
      return tube();
    case 3:
      return bumpy_sphere();
    case 4:
      return plate(uniform(1., 12.), 10000);
    case 5:
      return prism_of_random_polygon();
    default:
      return random_waves();
    }
  }
};

} // namespace comparison

#endif // POINT_SET_FLOW_BENCHMARK_RANDOM_SHAPES_H
