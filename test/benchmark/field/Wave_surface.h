// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_BENCHMARK_WAVE_SURFACE_H
#define POINT_SET_FLOW_BENCHMARK_WAVE_SURFACE_H

#include "measure/Surface.h"

#include <CGAL/number_utils.h>

#include <cmath>
#include <random>

namespace comparison {

/// Heights over a plane: a sum of waves, which has no end and no detail below its least wavelength.
class Wave_surface : public Surface {
  struct Wave {
    double height, kx, ky, phase;
  };
  std::vector<Wave> m_waves;

public:
  /// Five waves in random directions, with lengths from `wavelength` to three times as much. The
  /// slope is about .3 (rms) for a steepness of 1.
  Wave_surface(double wavelength, unsigned int seed, double steepness = 1.)
  {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0., 1.);
    for (int i = 0; i < 5; ++i) {
      const double length = wavelength * std::pow(3., unit(random));
      const double direction = CGAL_PI * unit(random), k = 2. * CGAL_PI / length;
      m_waves.push_back({.03 * steepness * length, k * std::cos(direction), k * std::sin(direction),
                         2. * CGAL_PI * unit(random)});
    }
  }

  double height(double x, double y) const
  {
    double z = 0.;
    for (const Wave& w : m_waves)
      z += w.height * std::sin(w.kx * x + w.ky * y + w.phase);
    return z;
  }
  Point_3 point(double x, double y) const { return {x, y, height(x, y)}; }

  /// The upper unit normal
  Vector_3 normal(double x, double y) const
  {
    double dx = 0., dy = 0.;
    for (const Wave& w : m_waves) {
      const double slope = w.height * std::cos(w.kx * x + w.ky * y + w.phase);
      dx += w.kx * slope;
      dy += w.ky * slope;
    }
    return Vector_3(-dx, -dy, 1.) / std::sqrt(1. + dx * dx + dy * dy);
  }

  /// Projects to tangent planes until the foot stays, as it does where p is nearer than the centers
  /// of curvature.
  Surface_point closest(const Point_3& p) const override
  {
    double x = p.x(), y = p.y();
    Vector_3 n = normal(x, y);
    double distance = (p - point(x, y)) * n;
    for (int i = 0; i < 30; ++i) {
      const Point_3 foot = p - distance * n;
      const double shift = CGAL::square(foot.x() - x) + CGAL::square(foot.y() - y);
      x = foot.x();
      y = foot.y();
      n = normal(x, y);
      distance = (p - point(x, y)) * n;
      if (shift < 1e-24)
        break;
    }
    return {p - distance * n, n, distance};
  }
};

} // namespace comparison

#endif // POINT_SET_FLOW_BENCHMARK_WAVE_SURFACE_H
