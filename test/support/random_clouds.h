// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_TEST_RANDOM_CLOUDS_H
#define CGAL_POINT_SET_FLOW_TEST_RANDOM_CLOUDS_H

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

// Small clouds of all kinds that make trouble, each made from its seed.
namespace random_clouds {

typedef CGAL::Simple_cartesian<double>::Point_3 Point_3;
typedef std::vector<Point_3> Points;

inline double extent(const Points& points)
{
  double largest = 0.;
  for (const Point_3& p : points)
    for (int d = 0; d < 3; ++d)
      largest = (std::max)(largest, std::abs(p[d] - points.front()[d]));
  return largest;
}

class Cloud {
  mutable std::mt19937 m_random;

public:
  Points points;
  std::string kind;

  explicit Cloud(unsigned int seed) : m_random(seed)
  {
    const unsigned int n = number(0, 3) == 0 ? number(0, 8) : number(9, 220);
    add(n);
    if (chance(.2)) { // clusters far apart
      kind += ", and far away ";
      const std::size_t half = points.size();
      add(n);
      const double far = std::pow(10., number(1, 12));
      for (std::size_t i = half; i < points.size(); ++i)
        points[i] = Point_3(points[i].x() + far, points[i].y(), points[i].z());
    }
    if (chance(.2) && !points.empty()) {
      kind += ", with duplicates";
      for (unsigned int i = number(1, 100); i != 0; --i)
        points.push_back(points[number(0, unsigned(points.size() - 1))]);
    }
    if (chance(.3) && kind.find("magnitudes") == kind.npos) {
      const double size = std::pow(10., double(number(0, 28)) * 20. - 290.);
      kind += ", times " + std::to_string(std::log10(size));
      for (Point_3& p : points)
        p = Point_3(p.x() * size, p.y() * size, p.z() * size);
    }
    else if (chance(.2)) {
      kind += ", georeferenced";
      for (Point_3& p : points)
        p = Point_3(p.x() + 4.5e5, p.y() + 5.4e6, p.z() + 100.);
    }
  }

  double uniform(double low = 0., double high = 1.) const
  {
    return std::uniform_real_distribution<double>(low, high)(m_random);
  }
  double normal() const { return std::normal_distribution<double>()(m_random); }
  unsigned int number(unsigned int first, unsigned int last) const
  {
    return std::uniform_int_distribution<unsigned int>(first, last)(m_random);
  }
  bool chance(double share) const { return uniform() < share; }

private:
  void add(unsigned int n)
  {
    static const char* const kinds[] = {"ball",       "plane", "two planes", "line",
                                        "sphere",     "edge",  "lattice",    "identical points",
                                        "magnitudes", "curve", "flat box"};
    const unsigned int which = number(0, 10);
    kind += kinds[which];
    const double noise = chance(.5) ? 0. : std::pow(10., -double(number(0, 6)));
    for (unsigned int i = 0; i < n; ++i) {
      double x = uniform(-1., 1.), y = uniform(-1., 1.), z = uniform(-1., 1.);
      switch (which) {
      case 1:
        z = 0.;
        break;
      case 2:
        z = .1 * (i % 2);
        break;
      case 3:
        y = 2. * x, z = -x;
        break;
      case 4: {
        const double r = std::hypot(x, y, z) + 1e-300;
        x /= r, y /= r, z /= r;
        break;
      }
      case 5:
        z = std::abs(x);
        break;
      case 6:
        x = number(0, 5), y = number(0, 5), z = number(0, 5);
        break;
      case 7:
        x = 1., y = 2., z = 3.;
        break;
      case 8:
        x = magnitude(), y = magnitude(), z = magnitude();
        break;
      case 9:
        y = std::cos(6. * x), z = std::sin(6. * x);
        break;
      case 10:
        z *= 1e-9;
        break;
      default:
        break;
      }
      if (which != 8)
        x += noise * normal(), y += noise * normal(), z += noise * normal();
      points.emplace_back(x, y, z);
    }
  }

  double magnitude() const
  {
    static const double magnitudes[] = {0.,  -0.,  5e-324, 1e-300, -1e-10, 1.,
                                        -1., 1e10, -1e15,  1e100,  1e300};
    return magnitudes[number(0, 10)];
  }
};

} // namespace random_clouds

#endif // CGAL_POINT_SET_FLOW_TEST_RANDOM_CLOUDS_H
