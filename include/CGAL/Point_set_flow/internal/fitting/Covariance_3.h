// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FITTING_COVARIANCE_3_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FITTING_COVARIANCE_3_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/Neighborhood_3.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// Eq. (1): the covariance matrix of a point and its neighbors about their centroid.
struct Covariance_3 {
  double xx = 0., xy = 0., xz = 0., yy = 0., yz = 0., zz = 0.;

  Covariance_3() = default;

  explicit Covariance_3(const Neighborhood_3& neighborhood)
  {
    const Point_3& p = neighborhood.center();
    // two passes: the smallest eigenvalue of a nearly flat neighborhood would not survive the
    // difference of two large sums
    Vector_3 mean(0., 0., 0.);
    for (std::size_t j = 0; j < neighborhood.size(); ++j)
      mean = mean + (neighborhood[j] - p);
    mean = mean / double(neighborhood.size() + 1);

    add(-mean);
    for (std::size_t j = 0; j < neighborhood.size(); ++j)
      add((neighborhood[j] - p) - mean);
  }

  void add(const Vector_3& d, double weight = 1.)
  {
    const double x = weight * d.x(), y = weight * d.y();
    xx += x * d.x(), xy += x * d.y(), xz += x * d.z();
    yy += y * d.y(), yz += y * d.z(), zz += weight * d.z() * d.z();
  }

  double trace() const { return xx + yy + zz; }
};

/// The direction of least variance and, Eq. (2), its share of the whole variance.
struct Smallest_eigenpair_3 {
  Vector_3 vector;
  double variation;
};

/// Slow, but accurate also where eigenvalues meet.
/// \pre the trace is positive
inline Smallest_eigenpair_3 smallest_eigenpair_by_eigen(const Covariance_3& c)
{
  const double scale = 1. / c.trace();
  Eigen::Matrix3d matrix;
  matrix << c.xx, c.xy, c.xz, c.xy, c.yy, c.yz, c.xz, c.yz, c.zz;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(matrix * scale);
  const Eigen::Vector3d v = solver.eigenvectors().col(0); // eigenvalues ascend
  return {Vector_3(v.x(), v.y(), v.z()), (std::max)(solver.eigenvalues()[0], 0.)};
}

/// The smallest root of the characteristic polynomial by its power series and by Halley's method, and the vector
/// that the other two eigenvectors leave. Where that does not come out well, because eigenvalues meet, by Eigen's
/// solver.
inline Smallest_eigenpair_3 smallest_eigenpair(const Covariance_3& c)
{
  const double trace = c.trace();
  if (!(trace > (std::numeric_limits<double>::min)()))
    return {Vector_3(0., 0., 1.), 0.}; // all points in one place
  const double scale = 1. / trace;
  const double xx = c.xx * scale, xy = c.xy * scale, xz = c.xz * scale;
  const double yy = c.yy * scale, yz = c.yz * scale, zz = c.zz * scale;

  const double minors = xx * yy - xy * xy + xx * zz - xz * xz + yy * zz - yz * yz;
  const double det = xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
  const double inverse = 1. / minors, first = det * inverse, ratio = first * inverse;
  double root = first * (1. + ratio * (1. + ratio * (2. - minors + ratio * (5. - 5. * minors))));
  for (int i = 0; i < 6; ++i) {
    const double value = ((root - 1.) * root + minors) * root - det;
    const double slope = (3. * root - 2.) * root + minors;
    const double half_curvature = 3. * root - 1.;
    const double step = value * slope / (slope * slope - value * half_curvature);
    root -= step;
    if (!(std::abs(step) > 4e-4)) // the digits triple from step to step
      break;
  }

  const Vector_3 rows[3] = {Vector_3(xx - root, xy, xz), Vector_3(xy, yy - root, yz),
                            Vector_3(xz, yz, zz - root)};
  Vector_3 vector(0., 0., 0.);
  double length = 0.;
  for (int i = 0; i < 3; ++i) {
    const Vector_3 v = cross_product(rows[i], rows[(i + 1) % 3]);
    if (v.squared_length() > length) {
      vector = v;
      length = v.squared_length();
    }
  }
  const Vector_3 image(xx * vector.x() + xy * vector.y() + xz * vector.z(),
                       xy * vector.x() + yy * vector.y() + yz * vector.z(),
                       xz * vector.x() + yz * vector.y() + zz * vector.z());
  const double variation = image * vector / length; // the Rayleigh quotient: twice as many digits
  if (!((image - variation * vector).squared_length() < 1e-16 * length)) // or not a number
    return smallest_eigenpair_by_eigen(c);
  return {vector / std::sqrt(length), (std::max)(variation, 0.)};
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FITTING_COVARIANCE_3_H
