// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FITTING_QUADRIC_RESIDUAL_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FITTING_QUADRIC_RESIDUAL_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/fitting/Covariance_3.h>
#include <CGAL/Point_set_flow/internal/parallel/Array.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// The deviation of points from a quadric fitted to them by least squares, with the degrees of
/// freedom of the quadric taken off: the noise, if the surface is smooth at this size.
/// \param neighbors the first entry is the point itself
inline double quadric_residual(const Array<Point_3>& points,
                               const std::vector<std::uint32_t>& neighbors, double radius)
{
  const Neighborhood_3 neighborhood(points.data(), neighbors[0], neighbors.data() + 1,
                                    neighbors.size() - 1, radius, 1.);
  const Vector_3 normal = smallest_eigenpair(Covariance_3(neighborhood)).vector;
  const Vector_3 axis = std::abs(normal.x()) < .6 ? Vector_3(1., 0., 0.) : Vector_3(0., 1., 0.);
  Vector_3 e1 = cross_product(normal, axis);
  e1 = e1 / std::sqrt(e1.squared_length());
  const Vector_3 e2 = cross_product(normal, e1);

  // The normal equations, which are as good here: within a neighborhood the terms are about 1.
  // sums[a][b] of x^a y^b, and with the height and its square
  double sums[5][5] = {}, heights[3][3] = {}, squares = 0.;
  for (const std::uint32_t j : neighbors) {
    const Vector_3 d = (points[j] - neighborhood.center()) / radius;
    const double dx = d * e1, dy = d * e2, h = d * normal;
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
  Eigen::Matrix<double, 6, 1> right;
  for (int i = 0; i < 6; ++i) {
    right[i] = heights[powers[i][0]][powers[i][1]];
    for (int j = 0; j < 6; ++j)
      products(i, j) = sums[powers[i][0] + powers[j][0]][powers[i][1] + powers[j][1]];
  }
  const double explained = right.dot(products.ldlt().solve(right));
  const double freedom = double(neighbors.size()) - 6.;
  return radius * std::sqrt((std::max)(squares - explained, 0.) / freedom);
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FITTING_QUADRIC_RESIDUAL_H
