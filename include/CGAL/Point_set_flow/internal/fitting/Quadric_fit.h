// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FITTING_QUADRIC_FIT_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FITTING_QUADRIC_FIT_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/fitting/Covariance_3.h>
#include <CGAL/Point_set_flow/internal/parallel/Array.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// A quadric fitted to a neighborhood by least squares: its residuals are the noise, if the surface is
/// smooth at this size.
class Quadric_fit {
  typedef Eigen::Matrix<double, 6, 1> Vector_6;

  const Array<Point_3>& m_points;
  const std::vector<std::uint32_t>& m_neighbors;
  double m_radius, m_freedom, m_squares;
  Vector_3 m_normal, m_e1, m_e2;
  Vector_6 m_quadric;

public:
  static constexpr std::size_t unknowns = 6;

  /// \param neighbors the first entry is the point itself; is kept by reference
  /// \pre there are more than 6, and the radius is positive
  Quadric_fit(const Array<Point_3>& points, const std::vector<std::uint32_t>& neighbors,
              double radius)
      : m_points(points), m_neighbors(neighbors), m_radius(radius),
        m_freedom(double(neighbors.size()) - double(unknowns))
  {
    find_frame();
    // The normal equations, which are as good here: within a neighborhood the terms are about 1.
    // sums[a][b] of x^a y^b, and with the height and its square
    double sums[5][5] = {}, heights[3][3] = {}, squares = 0.;
    for (const std::uint32_t j : m_neighbors) {
      const Vector_3 d = in_radii(j);
      const double dx = d * m_e1, dy = d * m_e2, h = d * m_normal;
      const double x[] = {1., dx, dx * dx}, y[] = {1., dy, dy * dy};
      for (int a = 0; a < 3; ++a)
        for (int b = 0; a + b < 3; ++b)
          heights[a][b] += x[a] * y[b] * h;
      squares += h * h;
      for (int a = 0; a < 5; ++a)
        for (int b = 0; a + b < 5; ++b)
          sums[a][b] += x[a / 2] * x[a - a / 2] * (y[b / 2] * y[b - b / 2]);
    }
    const int powers[6][2] = {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}};
    Eigen::Matrix<double, 6, 6> products;
    Vector_6 right;
    for (int i = 0; i < 6; ++i) {
      right[i] = heights[powers[i][0]][powers[i][1]];
      for (int j = 0; j < 6; ++j)
        products(i, j) = sums[powers[i][0] + powers[j][0]][powers[i][1] + powers[j][1]];
    }
    m_quadric = products.ldlt().solve(right);
    m_squares = (std::max)(squares - right.dot(m_quadric), 0.);
  }

  Quadric_fit(const Quadric_fit&) = delete; // refers to the points
  Quadric_fit& operator=(const Quadric_fit&) = delete;

  /// the standard deviation of the residuals, with the degrees of freedom of the quadric taken off
  double deviation() const { return m_radius * std::sqrt(m_squares / m_freedom); }

  /// The excess kurtosis of the residuals, with that of as many Gaussian numbers taken off: negative
  /// if they are flat-topped or bimodal
  double excess_kurtosis() const
  {
    double second = 0., fourth = 0.;
    for (const std::uint32_t j : m_neighbors) {
      const double residual = residual_of(j).z(), square = residual * residual;
      second += square;
      fourth += square * square;
    }
    const double m = double(m_neighbors.size());
    const double excess = m * fourth / (second * second) - 3. * (m - 1.) / (m + 1.);
    return std::isfinite(excess) ? excess : 0.; // no residuals, or squares that are too small
  }

  /// Geary's C of the residuals, which compares the nearest of them in the plane with each other: low if they are
  /// alike, as those of shape are. Points in one place are not compared. Negative if there is no residual.
  double gearys_c() const
  {
    const double one_place = .01; // in radii
    std::vector<Vector_3> residuals;
    double squares = 0.;
    for (const std::uint32_t j : m_neighbors) {
      residuals.push_back(residual_of(j));
      squares += residuals.back().z() * residuals.back().z();
    }
    double differences = 0.;
    for (const Vector_3& r : residuals) {
      double least = (std::numeric_limits<double>::infinity)(), nearest = r.z();
      for (const Vector_3& other : residuals) {
        const double dx = other.x() - r.x(), dy = other.y() - r.y(), squared = dx * dx + dy * dy;
        if (squared < least && squared > one_place * one_place) {
          least = squared;
          nearest = other.z();
        }
      }
      differences += (r.z() - nearest) * (r.z() - nearest);
    }
    return squares > 0. ? differences / (2. * squares) : -1.;
  }

private:
  Vector_3 in_radii(std::uint32_t j) const
  {
    return (m_points[j] - m_points[m_neighbors[0]]) / m_radius;
  }

  /// The place of a point in the plane, and its residual there
  Vector_3 residual_of(std::uint32_t j) const
  {
    const Vector_3 d = in_radii(j);
    const double x = d * m_e1, y = d * m_e2;
    Vector_6 terms;
    terms << 1., x, y, x * x, x * y, y * y;
    return {x, y, d * m_normal - m_quadric.dot(terms)};
  }

  void find_frame()
  {
    const Neighborhood_3 neighborhood(m_points.data(), m_neighbors[0], m_neighbors.data() + 1,
                                      m_neighbors.size() - 1, m_radius, 1.);
    m_normal = smallest_eigenpair(Covariance_3(neighborhood)).vector;
    const Vector_3 axis = std::abs(m_normal.x()) < .6 ? Vector_3(1., 0., 0.) : Vector_3(0., 1., 0.);
    m_e1 = cross_product(m_normal, axis);
    m_e1 = m_e1 / std::sqrt(m_e1.squared_length());
    m_e2 = cross_product(m_normal, m_e1);
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FITTING_QUADRIC_FIT_H
