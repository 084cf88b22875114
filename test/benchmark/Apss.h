// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_BENCHMARK_APSS_H
#define POINT_SET_FLOW_BENCHMARK_APSS_H

#include "measure/Nearest_points.h"
#include "measure/Smoothers.h"

#include <CGAL/for_each.h>

namespace comparison {

/// Algebraic point set surfaces (Guennebaud and Gross, SIGGRAPH 2007), a yardstick that CGAL does
/// not have: each point is projected to the algebraic sphere that fits the points and normals
/// around it.

/// f(x) = constant + linear x + quadratic x^2, zero on a sphere or a plane
struct Algebraic_sphere {
  double constant = 0., quadratic = 0.;
  Vector_3 linear = CGAL::NULL_VECTOR;

  /// The sphere nearest to x, found along its normal there; and that normal
  Vector_3 projection(Vector_3 x, Vector_3& normal) const
  {
    // Newton's method along the gradient stays well conditioned where the sphere becomes a plane
    for (int i = 0; i < 8; ++i) {
      normal = linear + 2. * quadratic * x;
      const double square = normal.squared_length();
      if (!(square > 0.))
        break;
      x -= (constant + linear * x + quadratic * x.squared_length()) / square * normal;
    }
    normal = linear + 2. * quadratic * x;
    return x;
  }
};

/// Sums over weighted points and normals, from which the sphere follows in closed form: its
/// gradients are nearest to the normals, then its values to zero.
class Sphere_fit {
  double m_w = 0., m_pp = 0., m_pn = 0.;
  Vector_3 m_p = CGAL::NULL_VECTOR, m_n = CGAL::NULL_VECTOR;

public:
  void add(double w, const Vector_3& p, const Vector_3& n)
  {
    m_w += w;
    m_p += w * p;
    m_n += w * n;
    m_pp += w * p.squared_length();
    m_pn += w * (p * n);
  }

  Algebraic_sphere sphere() const
  {
    Algebraic_sphere s;
    const double spread = m_pp - m_p.squared_length() / m_w;
    s.quadratic = spread > 0. ? .5 * (m_pn - m_p * m_n / m_w) / spread : 0.;
    s.linear = (m_n - 2. * s.quadratic * m_p) / m_w;
    s.constant = -(s.linear * m_p + s.quadratic * m_pp) / m_w;
    return s;
  }
};

/// Projects all points once, with weights (1 - d^2/h^2)^2 where h is the distance of the k-th
/// neighbor. Oriented unit normals are needed, and are replaced by those of the spheres. The paper's
/// exponent 4 and repeated projections were a little weaker on the whole, so not used: a yardstick
/// should be a good one.
inline void apss_project(Points& points, Vectors& normals, unsigned int k)
{
  const Nearest_points nearest(points);
  Points projected = points;
  Vectors new_normals = normals;
  CGAL::for_each<Concurrency_tag>(numbers(points.size()), [&](const std::size_t& i) {
    const auto neighbors = nearest(points[i], k + 1); // and the point itself
    const double h2 = neighbors.back().second;
    Sphere_fit fit; // with the point as origin
    for (const auto& neighbor : neighbors) {
      const double t = 1. - neighbor.second / h2;
      fit.add(t * t, points[neighbor.first] - points[i], normals[neighbor.first]);
    }
    Vector_3 normal;
    const Vector_3 x = fit.sphere().projection(CGAL::NULL_VECTOR, normal);
    if (x.squared_length() < h2 && normal.squared_length() > 0.) { // else there was no good fit
      projected[i] = points[i] + x;
      new_normals[i] = normal / std::sqrt(normal.squared_length());
    }
    return true;
  });
  points.swap(projected);
  normals.swap(new_normals);
}

/// Of points with oriented normals
inline Smoothed apss(const Points& noisy, const Vectors& normals, unsigned int k, int times = 1)
{
  Smoothed result{noisy, normals};
  for (int i = 0; i < times; ++i)
    apss_project(result.points, result.normals, k);
  return result;
}

} // namespace comparison

#endif // POINT_SET_FLOW_BENCHMARK_APSS_H
