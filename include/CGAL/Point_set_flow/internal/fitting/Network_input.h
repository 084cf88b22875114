// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FITTING_NETWORK_INPUT_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FITTING_NETWORK_INPUT_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/Neighborhood_3.h>
#include <CGAL/Point_set_flow/internal/fitting/Lanes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// What a network sees of a point: numbers of each neighbor, and of the point itself. They follow
/// translation, rotation and scaling. *Odd* ones change their sign with the normal of the point, *even*
/// ones do not change; of the normals of the neighbors only the lines count.
template <int EdgeEven, int EdgeOdd, int PointEven, int PointOdd>
struct Network_input {
  static constexpr int most = 32; ///< neighbors, spread over the neighborhood
  static constexpr int edge_even = EdgeEven, edge_odd = EdgeOdd, point_even = PointEven,
                       point_odd = PointOdd;
  typedef std::array<Lanes, most / 4> Edge_lanes; ///< one number for each neighbor

  int size;                                ///< the number of neighbors
  Edge_lanes mask;                         ///< 1 for each neighbor, 0 for those that miss
  Edge_lanes even[EdgeEven], odd[EdgeOdd]; ///< 0 for those that miss
  std::array<float, PointEven> of_point_even;
  std::array<float, PointOdd> of_point_odd;

  /// The number of lanes that are used
  std::size_t groups() const { return std::size_t(size + 3) / 4; }

protected:
  /// Where a neighbor is, in neighborhood radii
  struct Edge {
    std::size_t neighbor;
    double side; ///< 1, or -1 if the two normals point to opposite sides
  };

  explicit Network_input(const Neighborhood_3& neighborhood)
      : size(int((std::min)(neighborhood.size(), std::size_t(most))))
  {
    mask.fill(Lanes::Zero());
    for (int i = 0; i < size; ++i)
      at(mask, i) = 1.f;
    for (Edge_lanes& lanes : even)
      lanes.fill(Lanes::Zero());
    for (Edge_lanes& lanes : odd)
      lanes.fill(Lanes::Zero());
  }

  static float& at(Edge_lanes& lanes, int i) { return lanes[std::size_t(i) / 4][i % 4]; }

  /// Fills the first two even and odd lanes of a neighbor: its distance in the tangent plane and the angle of the
  /// normals; its height above the tangent plane, and the height of its own plane.
  Edge read_edge(const Neighborhood_3& neighborhood, int i)
  {
    const std::size_t j = std::size_t(i) * neighborhood.size() / std::size_t(size);
    const Vector_3 d = (neighborhood[j] - neighborhood.center()) / neighborhood.radius();
    const double cosine = neighborhood.normal(j) * neighborhood.normal();
    const double side = cosine < 0. ? -1. : 1.;
    const double height = d * neighborhood.normal(), other = d * neighborhood.normal(j) * side;
    const double tangential = std::sqrt((std::max)(d * d - height * height, 0.));
    const double angle = std::sqrt((std::max)(2. - 2. * std::abs(cosine), 0.)); // for small ones
    at(even[0], i) = static_cast<float>(2. * tangential - 1.);
    at(even[1], i) = static_cast<float>(1.5 * angle);
    at(odd[0], i) = static_cast<float>(height);
    at(odd[1], i) = static_cast<float>(other);
    return {j, side};
  }

  /// Close to x, but between -4 and 4
  static float squashed(float x) { return x / std::sqrt(1.f + x * x * (1.f / 16.f)); }
  /// The same of all numbers, in a unit
  static void squash(Edge_lanes& numbers, float unit)
  {
    const float factor = 1.f / unit;
    for (Lanes& lanes : numbers) {
      const Lanes x = lanes * factor;
      lanes = x / (1.f + x * x * (1.f / 16.f)).sqrt();
    }
  }

  static float limited(double x, double limit)
  {
    return static_cast<float>((std::min)((std::max)(x, -limit), limit));
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FITTING_NETWORK_INPUT_H
