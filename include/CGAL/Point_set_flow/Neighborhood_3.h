// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_NEIGHBORHOOD_3_H
#define CGAL_POINT_SET_FLOW_NEIGHBORHOOD_3_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/Compact_length.h>
#include <CGAL/Point_set_flow/Compact_vector_3.h>
#include <CGAL/Point_set_flow/Core_kernel.h>
#include <CGAL/Point_set_flow/Side_3.h>

#include <boost/config.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Point_set_flow {

/// \ingroup PkgPointSetFlowCurvature
/// Whether the neighbors of a point are those of two sheets of the surface, and on which one the point is.
struct Sheet_evidence {
  float two_sheets = 0.f; ///< the logarithm of the odds that there are two
  float side =
      0.f; ///< the logarithm of the odds that the point is on the side to which its normal points
};

/// \ingroup PkgPointSetFlowCurvature
/// What is known of a surface around a point, besides the points.
struct Surface_estimate_3 {
  /// one for each point, or null. Four bytes behind the last one are read, too, but not used.
  const Compact_vector_3* normals = nullptr;
  double noise = 0.;   ///< the standard deviation of the noise
  double spacing = 0.; ///< the spacing around the point
  double time = 0.;    ///< 0 in the first step of the flow, 1 in the last
  /// for each point, the side of the surface on which it was measured, given or found, if it is known and to be
  /// trusted; or null
  const Side_3* sides = nullptr;
  /// for each point, how far it was above the place where it is now before the flow, along its normal, in its
  /// neighborhood radius; or null
  const float* residuals = nullptr;
  /// for each point, the neighborhood radius, if the residuals are known
  const Compact_length* radii = nullptr;
  const Sheet_evidence* sheets = nullptr; ///< for each point, or null
  /// the standard deviation of the distances from the tangent planes around the point, if there is evidence of sheets
  double deviation = 0.;
  double excess = 0.; ///< the excess kurtosis of these distances, negative for two sheets
};

/// \cond SKIP_IN_MANUAL
namespace internal {

/// The numbers of the neighbors of a point: a view
class Neighbor_numbers {
  const std::uint32_t* m_absolute = nullptr;
  const std::int16_t* m_relative = nullptr; // to the number of the point, if not null
  std::size_t m_point = 0, m_size;

public:
  Neighbor_numbers(const std::uint32_t* numbers, std::size_t size)
      : m_absolute(numbers), m_size(size)
  {}
  Neighbor_numbers(std::size_t point, const std::int16_t* relative, std::size_t size)
      : m_relative(relative), m_point(point), m_size(size)
  {}

  std::size_t size() const { return m_size; }
  /// the first of them, which are the nearest if they are in that order
  Neighbor_numbers nearest(std::size_t most) const
  {
    Neighbor_numbers some = *this;
    some.m_size = most < m_size ? most : m_size;
    return some;
  }
  BOOST_FORCEINLINE std::uint32_t operator[](std::size_t j) const
  {
    return m_relative
               ? static_cast<std::uint32_t>(m_point + std::size_t(std::ptrdiff_t(m_relative[j])))
               : m_absolute[j];
  }
};

} // namespace internal
/// \endcond

/// \ingroup PkgPointSetFlowCurvature
/// A point with its nearest neighbors, as a curvature estimator sees it: a view on the arrays of
/// the core, cheap to make and to copy.
///
/// The coordinates are those of the data moved to the origin, so that differences between points
/// keep their digits far from the origin.
class Neighborhood_3 {
  const Point_3* m_points;
  internal::Neighbor_numbers m_neighbors;
  std::size_t m_center;
  double m_radius, m_filter_width;
  Surface_estimate_3 m_surface;

public:
  /// \param points the points of the surface
  /// \param center the index of the point in the middle
  /// \param neighbors, size the indices of its neighbors, in any order, without itself
  /// \param radius the neighborhood radius: the distance of the farthest neighbor
  /// \param filter_width \f$\sigma\f$ of \f$G\f$ in multiples of the radius
  /// \param surface what else is known
  Neighborhood_3(const Point_3* points, std::size_t center, const std::uint32_t* neighbors,
                 std::size_t size, double radius, double filter_width,
                 const Surface_estimate_3& surface = Surface_estimate_3())
      : Neighborhood_3(points, center, internal::Neighbor_numbers(neighbors, size), radius,
                       filter_width)
  {
    m_surface = surface;
  }
  /// \cond SKIP_IN_MANUAL
  Neighborhood_3(const Point_3* points, std::size_t center,
                 const internal::Neighbor_numbers& neighbors, double radius, double filter_width)
      : m_points(points), m_neighbors(neighbors), m_center(center), m_radius(radius),
        m_filter_width(filter_width)
  {}
  /// \endcond

  /// the point in the middle
  const Point_3& center() const { return m_points[m_center]; }
  /// the number of neighbors, the point itself not counted
  std::size_t size() const { return m_neighbors.size(); }
  /// a neighbor
  const Point_3& operator[](std::size_t j) const { return m_points[m_neighbors[j]]; }
  /// the neighborhood radius
  double radius() const { return m_radius; }

  /// whether the normals of the points are known: from the second step on if the estimator declares
  /// `Uses_surface_estimate`, and then always in `directional_curvature()`
  bool has_normals() const { return m_surface.normals != nullptr; }
  /// the unit normal of the point in the middle. It points to the side of the point if that is known, see
  /// `is_sided()`; else its orientation is arbitrary.
  /// \pre `has_normals()`
  Vector_3 normal() const { return m_surface.normals[m_center].vector(); }
  /// the unit normal of a neighbor
  /// \pre `has_normals()`
  Vector_3 normal(std::size_t j) const { return m_surface.normals[m_neighbors[j]].vector(); }

  /// whether the side of the point is known: the caller gave a normal that is trusted, or two sheets were
  /// told apart
  bool is_sided() const { return m_surface.sides && m_surface.sides[m_center].is_known(); }
  /// whether a neighbor is known to be on the opposite side, hence another sheet of the surface
  /// \pre `is_sided()`
  bool is_opposite(std::size_t j) const
  {
    const Side_3& other = m_surface.sides[m_neighbors[j]];
    if (!other.is_known())
      return false;
    if (has_normals()) // which are oriented as the sides, and more accurate
      return normal(j) * normal() < 0.;
    return other.vector() * side() < 0.;
  }

  /// whether there is evidence of sheets: in `find_sheets()` only
  bool has_sheets() const { return m_surface.sheets != nullptr; }
  /// what the round before found of the point in the middle
  /// \pre `has_sheets()`
  const Sheet_evidence& sheets() const { return m_surface.sheets[m_center]; }
  /// what the round before found of a neighbor
  /// \pre `has_sheets()`
  const Sheet_evidence& sheets(std::size_t j) const { return m_surface.sheets[m_neighbors[j]]; }

  /// the standard deviation of the distances from the tangent planes
  /// \pre `has_sheets()`
  double deviation() const { return m_surface.deviation; }
  /// the excess kurtosis of these distances
  /// \pre `has_sheets()`
  double excess_kurtosis() const { return m_surface.excess; }

  /// whether the residuals are known: in `correction()` only
  bool has_residuals() const { return m_surface.residuals != nullptr; }
  /// the height of the point in the middle before the flow above where it is now, along its normal
  /// \pre `has_residuals()`
  double residual() const { return residual_of(m_center); }
  /// the residual of a neighbor, along its own normal
  /// \pre `has_residuals()`
  double residual(std::size_t j) const { return residual_of(m_neighbors[j]); }

  /// the standard deviation of the noise around the point, as estimated before the first step; 0
  /// unless the estimator declares `Uses_surface_estimate`
  double noise() const { return m_surface.noise; }
  /// the spacing around the point
  double spacing() const { return m_surface.spacing; }
  /// how far the flow has come: 0 in its first step, 1 in its last
  double time() const { return m_surface.time; }

  /// \cond SKIP_IN_MANUAL
  /// what is known of the surface, to be filled in where it is: copies of so many members would be slow
  Surface_estimate_3& surface_estimate() { return m_surface; }
  Vector_3 side() const { return m_surface.sides[m_center].vector(); }
  const Point_3* points() const { return m_points; }
  const Compact_vector_3* normals() const { return m_surface.normals; }
  const internal::Neighbor_numbers& numbers() const { return m_neighbors; }
  std::size_t center_number() const { return m_center; }
  double filter_width() const { return m_filter_width; }
  /// the same point with some of its neighbors, of which no side is known
  Neighborhood_3 with_neighbors(const std::uint32_t* neighbors, std::size_t size) const
  {
    Neighborhood_3 part = *this;
    part.m_neighbors = internal::Neighbor_numbers(neighbors, size);
    part.m_surface.sides = nullptr;
    return part;
  }
  /// \endcond

  /// \f$\sigma\f$ of the Gaussian of equation (3), a length
  double gaussian_width() const { return m_filter_width * m_radius; }

  /// \f$G(x) = e^{-x^2 / 2\sigma^2}\f$ of equation (3)
  double gaussian(double squared_distance) const
  {
    const double sigma = gaussian_width(), divisor = 2. * sigma * sigma;
    // a width of 0, or a neighborhood shrunk to a point, leaves the point alone
    return divisor > 0. ? std::exp(-squared_distance / divisor) : (squared_distance > 0. ? 0. : 1.);
  }

private:
  double residual_of(std::size_t i) const
  {
    return double(m_surface.residuals[i]) * m_surface.radii[i].value();
  }
};

} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_NEIGHBORHOOD_3_H
