// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_TEST_SHAPES_H
#define CGAL_POINT_SET_FLOW_TEST_SHAPES_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

// Point samples of shapes with known answers, the same in each run.
namespace shapes {

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point_3;
typedef Kernel::Vector_3 Vector_3;
typedef std::vector<Point_3> Points;

/// n points on a sphere around the origin, evenly spread (Fibonacci lattice)
inline Points sphere(std::size_t n, double radius)
{
  Points points;
  for (std::size_t i = 0; i < n; ++i) {
    const double z = 1. - 2. * (double(i) + .5) / double(n), r = std::sqrt(1. - z * z);
    const double angle = CGAL_PI * (3. - std::sqrt(5.)) * double(i);
    points.emplace_back(radius * r * std::cos(angle), radius * r * std::sin(angle), radius * z);
  }
  return points;
}

/// n points spread evenly over a disc of radius 1 in the plane z = 0 (sunflower), the center first
inline Points disc(std::size_t n)
{
  Points points;
  for (std::size_t i = 0; i < n; ++i) {
    const double r = std::sqrt(double(i) / double(n)),
                 angle = CGAL_PI * (3. - std::sqrt(5.)) * double(i);
    points.emplace_back(r * std::cos(angle), r * std::sin(angle), 0.);
  }
  return points;
}

/// The surface of the cube [-1, 1]^3, m times m points on each face, each moved by up to half of
/// a cell within the face so that there is no lattice
inline Points cube(int m)
{
  Points points;
  std::mt19937 random(17);
  std::uniform_real_distribution<double> jitter(.1, .9);
  for (int face = 0; face < 6; ++face)
    for (int i = 0; i < m; ++i)
      for (int j = 0; j < m; ++j) {
        const double side = face < 3 ? 1. : -1.;
        const double a = 2. * (i + jitter(random)) / m - 1., b = 2. * (j + jitter(random)) / m - 1.;
        const double c[3] = {side, a, b};
        points.emplace_back(c[(3 - face % 3) % 3], c[(4 - face % 3) % 3], c[(5 - face % 3) % 3]);
      }
  return points;
}

/// The distance of a point to the surface of the cube [-1, 1]^3
inline double distance_to_cube(const Point_3& p)
{
  const double x = std::abs(p.x()), y = std::abs(p.y()), z = std::abs(p.z());
  const double dx = (std::max)(x - 1., 0.), dy = (std::max)(y - 1., 0.),
               dz = (std::max)(z - 1., 0.);
  const double outside = std::sqrt(dx * dx + dy * dy + dz * dz);
  return outside > 0. ? outside : 1. - (std::max)({x, y, z});
}

/// Adds Gaussian noise, the same in all directions
template <typename Point, typename Allocator>
void add_noise(std::vector<Point, Allocator>& points, double sigma, unsigned int seed = 1)
{
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0., sigma);
  for (Point& p : points) {
    const double x = noise(random), y = noise(random), z = noise(random);
    typedef typename CGAL::Kernel_traits<Point>::Kernel::FT FT;
    p = Point(p.x() + FT(x), p.y() + FT(y), p.z() + FT(z));
  }
}

/// A cube with noise, of 6 m * m points
inline Points noisy_cube(int m = 16, double sigma = .02)
{
  Points points = cube(m);
  add_noise(points, sigma);
  return points;
}

inline double largest_difference(const Points& a, const Points& b)
{
  double largest = 0.;
  for (std::size_t i = 0; i < a.size(); ++i)
    largest = (std::max)(largest, CGAL::squared_distance(a[i], b[i]));
  return std::sqrt(largest);
}

/// The root of the mean square of `distance` over the points
template <typename Distance>
double rms(const Points& points, const Distance& distance)
{
  double sum = 0.;
  for (const Point_3& p : points)
    sum += distance(p) * distance(p);
  return std::sqrt(sum / double(points.size()));
}

inline double distance_to_origin(const Point_3& p)
{
  return std::sqrt((p - CGAL::ORIGIN).squared_length());
}

inline double mean_radius(const Points& points)
{
  double sum = 0.;
  for (const Point_3& p : points)
    sum += distance_to_origin(p);
  return sum / double(points.size());
}

} // namespace shapes

#endif // CGAL_POINT_SET_FLOW_TEST_SHAPES_H
