// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_NEIGHBORHOOD_3_H
#define CGAL_POINT_SET_FLOW_NEIGHBORHOOD_3_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/Core_kernel.h>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Point_set_flow {

/// \ingroup PkgPointSetFlowCurvature
/// What is known of a surface around a point, besides the points.
struct Surface_estimate_3 {
  const Vector_3* normals = nullptr; ///< one for each point, or null
  double noise = 0.;                 ///< the standard deviation of the noise
  double spacing = 0.;               ///< the spacing of the point set
  double time = 0.;                  ///< 0 in the first step of the flow, 1 in the last
};

/// \ingroup PkgPointSetFlowCurvature
/// A point with its nearest neighbors, as a curvature estimator sees it: a view on the arrays of
/// the core, cheap to make and to copy.
///
/// The coordinates are those of the data moved to the origin, so that differences between points
/// keep their digits far from the origin.
class Neighborhood_3 {
  const Point_3* m_points;
  const std::uint32_t* m_neighbors;
  std::size_t m_size, m_center;
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
      : m_points(points), m_neighbors(neighbors), m_size(size), m_center(center), m_radius(radius),
        m_filter_width(filter_width), m_surface(surface)
  {}

  /// the point in the middle
  const Point_3& center() const { return m_points[m_center]; }
  /// the number of neighbors, the point itself not counted
  std::size_t size() const { return m_size; }
  /// a neighbor
  const Point_3& operator[](std::size_t j) const { return m_points[m_neighbors[j]]; }
  /// the neighborhood radius
  double radius() const { return m_radius; }

  /// whether the normals of the points are known: from the second step on if the estimator declares
  /// `Uses_surface_estimate`, and then always in `directional_curvature()`
  bool has_normals() const { return m_surface.normals != nullptr; }
  /// the unit normal of the point in the middle; its orientation is arbitrary
  /// \pre `has_normals()`
  const Vector_3& normal() const { return m_surface.normals[m_center]; }
  /// the unit normal of a neighbor
  /// \pre `has_normals()`
  const Vector_3& normal(std::size_t j) const { return m_surface.normals[m_neighbors[j]]; }

  /// the standard deviation of the noise around the point, as estimated before the first step; 0
  /// unless the estimator declares `Uses_surface_estimate`
  double noise() const { return m_surface.noise; }
  /// the spacing of the point set
  double spacing() const { return m_surface.spacing; }
  /// how far the flow has come: 0 in its first step, 1 in its last
  double time() const { return m_surface.time; }

  /// \f$\sigma\f$ of the Gaussian of equation (3), a length
  double gaussian_width() const { return m_filter_width * m_radius; }

  /// \f$G(x) = e^{-x^2 / 2\sigma^2}\f$ of equation (3)
  double gaussian(double squared_distance) const
  {
    const double sigma = gaussian_width(), divisor = 2. * sigma * sigma;
    // a width of 0, or a neighborhood shrunk to a point, leaves the point alone
    return divisor > 0. ? std::exp(-squared_distance / divisor) : (squared_distance > 0. ? 0. : 1.);
  }
};

} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_NEIGHBORHOOD_3_H
