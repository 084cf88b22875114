// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_BENCHMARK_UNEVEN_CLOUDS_H
#define POINT_SET_FLOW_BENCHMARK_UNEVEN_CLOUDS_H

#include "Cloud_maker.h"
#include "Joined_surfaces.h"

namespace comparison {

/// Clouds that are much denser at one place than at another.
namespace field_clouds {

/// A dense part beside one with five times its spacing, and the same noise
inline Test_cloud dense_beside_sparse(Cloud_maker make)
{
  const double dense = .2;
  const double sigma = .4 * dense * make.variation.noise;
  const double height = std::sqrt(.6 * double(make.variation.n)); // of a square of sparse points
  const double width = .4 * double(make.variation.n) * dense * dense / height;
  const auto surface = make.terrain();
  Test_cloud cloud;
  cloud.name = "dense beside sparse";
  cloud.surface = surface;
  cloud.spacing = dense;
  const auto add = [&](double x, double y) {
    cloud.points.push_back(surface->point(x, y) + make.isotropic(sigma));
  };
  make.grid(-width, 0., 0., height, dense, dense, .8, add);
  make.grid(0., height, 0., height, 1., 1., .8, add);
  return cloud;
}

/// A scanned object, a ball on a thin stand, above a floor that has four times its spacing
inline Test_cloud object_on_floor(Cloud_maker make)
{
  const double h = std::sqrt(4. * CGAL_PI / (.4 * double(make.variation.n)));
  const double sigma = .25 * h * make.variation.noise;
  const Point_3 center(0., 0., 2.5);
  auto surface = std::make_shared<Joined_surfaces>();
  surface->add(std::make_unique<Sphere_surface>(center, 1.));
  surface->add(std::make_unique<Plane_surface>(CGAL::ORIGIN, Vector_3(0., 0., 1.)));
  Test_cloud cloud;
  cloud.name = "object on coarse floor";
  cloud.surface = surface;
  cloud.spacing = h;
  const double rows = std::round(CGAL_PI / h); // each with as many points as its length asks for
  for (double row = .5; row < rows; row += 1.) {
    const double r = std::sin(CGAL_PI * row / rows), z = std::cos(CGAL_PI * row / rows);
    const double turns = std::round(2. * CGAL_PI * r / h);
    for (double turn = 0.; turn < turns; turn += 1.) {
      const double u = 2. * CGAL_PI * (turn + make.uniform(-.4, .4)) / turns;
      const Vector_3 direction(r * std::cos(u), r * std::sin(u), z);
      cloud.points.push_back(center + direction + make.isotropic(sigma));
    }
  }
  const double half = 2. * h * std::sqrt(.6 * double(make.variation.n));
  make.grid(-half, half, -half, half, 4. * h, 4. * h, .8, [&](double x, double y) {
    cloud.points.push_back(Point_3(x, y, 0.) + make.isotropic(sigma));
  });
  return cloud;
}

/// A scanner above a street: the density falls with the square of the range, and the noise is the same
/// everywhere. In meters.
inline Test_cloud street(Cloud_maker make)
{
  const double nearest = 1., farthest = 14.;
  const auto surface = std::make_shared<Wave_surface>(60., make.variation.seed + 1, .3);
  Test_cloud cloud;
  cloud.name = "street scan";
  cloud.surface = surface;
  while (cloud.points.size() < make.variation.n) {
    // the logarithm of the range is evenly distributed
    const double range = nearest * std::pow(farthest / nearest, make.uniform(0., 1.));
    const double angle = make.uniform(0., 2. * CGAL_PI);
    cloud.points.push_back(surface->point(range * std::cos(angle), range * std::sin(angle)) +
                           make.isotropic(.02 * make.variation.noise));
  }
  cloud.spacing = typical_spacing(cloud.points);
  return cloud;
}

} // namespace field_clouds

} // namespace comparison

#endif // POINT_SET_FLOW_BENCHMARK_UNEVEN_CLOUDS_H
