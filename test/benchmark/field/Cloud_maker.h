// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_BENCHMARK_CLOUD_MAKER_H
#define POINT_SET_FLOW_BENCHMARK_CLOUD_MAKER_H

#include "Test_cloud.h"
#include "Wave_surface.h"

namespace comparison {

/// One instance of a cloud: as it is described, with factors on its number of points, its noise and
/// the wavelength of its terrain.
struct Variation {
  std::size_t n;
  double noise, wavelength;
  unsigned int seed;
};

/// What the generators of clouds have in common: random numbers and patterns of places.
class Cloud_maker {
  std::mt19937 m_random;

public:
  const Variation variation;

  explicit Cloud_maker(const Variation& v) : m_random(v.seed), variation(v) {}

  double uniform(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(m_random);
  }
  double normal(double sigma) { return std::normal_distribution<double>(0., sigma)(m_random); }
  Vector_3 isotropic(double sigma)
  {
    const double x = normal(sigma), y = normal(sigma);
    return {x, y, normal(sigma)};
  }

  /// Terrain with waves of so many spacings and more
  std::shared_ptr<const Wave_surface> terrain(double wavelength = 50.) const
  {
    return std::make_shared<Wave_surface>(wavelength * variation.wavelength, variation.seed + 1);
  }

  /// Calls `visit(x, y)` for the places of a grid, each moved by up to `jitter` of a cell.
  template <typename Visit>
  void grid(double x0, double x1, double y0, double y1, double dx, double dy, double jitter,
            const Visit& visit)
  {
    for (double x = x0 + dx / 2.; x < x1; x += dx)
      for (double y = y0 + dy / 2.; y < y1; y += dy) {
        const double shift = jitter * dx * uniform(-.5, .5);
        visit(x + shift, y + jitter * dy * uniform(-.5, .5));
      }
  }
  /// The same for n places with a spacing of 1 in a square
  template <typename Visit>
  void square(std::size_t n, double jitter, const Visit& visit)
  {
    const double half = std::sqrt(double(n)) / 2.;
    grid(-half, half, -half, half, 1., 1., jitter, visit);
  }
};

} // namespace comparison

#endif // POINT_SET_FLOW_BENCHMARK_CLOUD_MAKER_H
