// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FITTING_QUADRIC_RESIDUAL_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FITTING_QUADRIC_RESIDUAL_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/fitting/Covariance_3.h>
#include <CGAL/Point_set_flow/internal/parallel/Array.h>

#include <Eigen/Dense>

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

  const Eigen::Index m = Eigen::Index(neighbors.size());
  Eigen::Matrix<double, Eigen::Dynamic, 6> terms(m, 6);
  Eigen::VectorXd height(m);
  for (Eigen::Index j = 0; j < m; ++j) {
    const Vector_3 d = (points[neighbors[std::size_t(j)]] - neighborhood.center()) / radius;
    const double x = d * e1, y = d * e2;
    terms.row(j) << 1., x, y, x * x, x * y, y * y;
    height[j] = d * normal;
  }
  // the normal equations, which are as good here: within a neighborhood the terms are about 1
  const Eigen::Matrix<double, 6, 6> products = terms.transpose() * terms;
  const Eigen::Matrix<double, 6, 1> heights = terms.transpose() * height;
  const Eigen::VectorXd rest = height - terms * products.colPivHouseholderQr().solve(heights);
  return radius * std::sqrt(rest.squaredNorm() / double(m - 6));
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FITTING_QUADRIC_RESIDUAL_H
