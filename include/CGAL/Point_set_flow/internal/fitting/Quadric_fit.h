// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FITTING_QUADRIC_FIT_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FITTING_QUADRIC_FIT_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/fitting/Covariance_3.h>
#include <CGAL/Point_set_flow/internal/parallel/Array.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
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
public:
  static constexpr std::size_t unknowns = 6;

private:
  typedef std::array<double, unknowns> Vector_6;
  typedef std::array<Vector_6, unknowns> Matrix_6;
  enum Column { X, Y, XX, XY, YY, HEIGHT, NUMBER_OF_COLUMNS };

  double m_radius, m_freedom, m_squares;
  Eigen::Array<double, Eigen::Dynamic, NUMBER_OF_COLUMNS>
      m_terms; // of each point, in its frame and in radii
  Vector_6 m_quadric;

public:
  /// \param neighbors the first entry is the point itself
  /// \pre there are more than 6, and the radius is positive
  Quadric_fit(const Array<Point_3>& points, const std::vector<std::uint32_t>& neighbors,
              double radius)
      : m_radius(radius), m_freedom(double(neighbors.size()) - double(unknowns)),
        m_terms(Eigen::Index(neighbors.size()), NUMBER_OF_COLUMNS)
  {
    find_terms(points, neighbors);
    // The normal equations, which are as good here: within a neighborhood the terms are about 1.
    Matrix_6 products; // the lower triangle
    Vector_6 right;
    products[0][0] = double(neighbors.size());
    right[0] = m_terms.col(HEIGHT).sum();
    for (int i = 1; i < 6; ++i) {
      products[std::size_t(i)][0] = m_terms.col(i - 1).sum();
      right[std::size_t(i)] = dot(i - 1, HEIGHT);
      for (int j = 1; j <= i; ++j)
        products[std::size_t(i)][std::size_t(j)] = dot(i - 1, j - 1);
    }
    m_quadric = solve(products, right);
    m_squares = dot(HEIGHT, HEIGHT);
    for (std::size_t i = 0; i < unknowns; ++i)
      m_squares -= right[i] * m_quadric[i];
    m_squares = (std::max)(m_squares, 0.);
  }

  /// the standard deviation of the residuals, with the degrees of freedom of the quadric taken off
  double deviation() const { return m_radius * std::sqrt(m_squares / m_freedom); }

  /// The excess kurtosis of the residuals, with that of as many Gaussian numbers taken off: negative
  /// if they are flat-topped or bimodal
  double excess_kurtosis() const
  {
    const Eigen::ArrayXd squares = residuals().square();
    const double second = squares.sum(), fourth = squares.square().sum();
    const double m = double(squares.size());
    const double excess = m * fourth / (second * second) - 3. * (m - 1.) / (m + 1.);
    return std::isfinite(excess) ? excess : 0.; // no residuals, or squares that are too small
  }

  /// Geary's C of the residuals, which compares the nearest of them in the plane with each other: low if they are
  /// alike, as those of shape are. Points in one place are not compared. Negative if there is no residual.
  double gearys_c() const
  {
    const double one_place = .01; // in radii
    const Eigen::ArrayXd residual = residuals();
    double differences = 0.;
    for (Eigen::Index i = 0; i < residual.size(); ++i) {
      double least = (std::numeric_limits<double>::infinity)();
      Eigen::Index nearest = i;
      for (Eigen::Index j = 0; j < residual.size(); ++j) {
        const double dx = m_terms(j, X) - m_terms(i, X), dy = m_terms(j, Y) - m_terms(i, Y);
        const double squared = dx * dx + dy * dy;
        const bool is_nearer = (squared < least) & (squared > one_place * one_place);
        least = is_nearer ? squared : least; // without branches
        nearest = is_nearer ? j : nearest;
      }
      const double difference = residual[i] - residual[nearest];
      differences += difference * difference;
    }
    const double squares = residual.square().sum();
    return squares > 0. ? differences / (2. * squares) : -1.;
  }

private:
  double dot(int a, int b) const { return (m_terms.col(a) * m_terms.col(b)).sum(); }

  /// Solves normal equations by the factors \f$LDL^T\f$. Terms that depend on those before get the coefficient 0, as
  /// where all points are on a line. Eigen's `LDLT` would take the compiler seconds in each program.
  /// \param a symmetric, the lower triangle; becomes L and D
  static Vector_6 solve(Matrix_6& a, Vector_6 x)
  {
    const double least = 1e-13; // of the square of a term
    for (std::size_t i = 0; i < unknowns; ++i) {
      Vector_6 scaled; // row of L, times D
      double rest = a[i][i];
      for (std::size_t j = 0; j < i; ++j) {
        scaled[j] = a[i][j];
        for (std::size_t k = 0; k < j; ++k)
          scaled[j] -= scaled[k] * a[j][k];
        a[i][j] = a[j][j] > 0. ? scaled[j] / a[j][j] : 0.;
        rest -= scaled[j] * a[i][j];
        x[i] -= a[i][j] * x[j];
      }
      a[i][i] = rest > least * a[i][i] ? rest : 0.;
    }
    for (std::size_t i = unknowns; i-- > 0;) {
      x[i] = a[i][i] > 0. ? x[i] / a[i][i] : 0.;
      for (std::size_t j = i + 1; j < unknowns; ++j)
        x[i] -= a[j][i] * x[j];
    }
    return x;
  }

  Eigen::ArrayXd residuals() const
  {
    Eigen::ArrayXd heights = m_terms.col(HEIGHT) - m_quadric[0];
    for (int i = 0; i < HEIGHT; ++i)
      heights -= m_terms.col(i) * m_quadric[std::size_t(i) + 1];
    return heights;
  }

  void find_terms(const Array<Point_3>& points, const std::vector<std::uint32_t>& neighbors)
  {
    const Neighborhood_3 neighborhood(points.data(), neighbors[0], neighbors.data() + 1,
                                      neighbors.size() - 1, m_radius, 1.);
    const Vector_3 normal = smallest_eigenpair(Covariance_3(neighborhood)).vector;
    const Vector_3 axis = std::abs(normal.x()) < .6 ? Vector_3(1., 0., 0.) : Vector_3(0., 1., 0.);
    Vector_3 e1 = cross_product(normal, axis);
    e1 = e1 / std::sqrt(e1.squared_length());
    const Vector_3 e2 = cross_product(normal, e1);
    const double scale = 1. / m_radius;
    for (std::size_t i = 0; i < neighbors.size(); ++i) {
      const Vector_3 d = (points[neighbors[i]] - points[neighbors[0]]) * scale;
      const Eigen::Index row = Eigen::Index(i);
      m_terms(row, X) = d * e1;
      m_terms(row, Y) = d * e2;
      m_terms(row, HEIGHT) = d * normal;
    }
    m_terms.col(XX) = m_terms.col(X).square();
    m_terms.col(XY) = m_terms.col(X) * m_terms.col(Y);
    m_terms.col(YY) = m_terms.col(Y).square();
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FITTING_QUADRIC_FIT_H
