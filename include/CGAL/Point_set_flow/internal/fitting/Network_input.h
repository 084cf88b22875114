// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FITTING_NETWORK_INPUT_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FITTING_NETWORK_INPUT_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/Neighborhood_3.h>
#include <CGAL/Point_set_flow/internal/fitting/Neighbor_lanes.h>

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
  typedef std::array<Lanes, most / lane_width> Edge_lanes; ///< one number for each neighbor

  int size;                                ///< the number of neighbors
  Edge_lanes mask;                         ///< 1 for each neighbor, 0 for those that miss
  Edge_lanes even[EdgeEven], odd[EdgeOdd]; ///< 0 for those that miss
  std::array<float, PointEven> of_point_even;
  std::array<float, PointOdd> of_point_odd;

  /// The number of lanes that are used
  std::size_t groups() const { return (std::size_t(size) + lane_width - 1) / lane_width; }
  /// how many of the numbers in them miss
  std::size_t pads() const { return groups() * lane_width - std::size_t(size); }

protected:
  explicit Network_input(const Neighborhood_3& neighborhood)
      : size(int((std::min)(neighborhood.size(), std::size_t(most))))
  {
    // not copied: compilers copy wide lanes by halves, which are slow to read together soon after
    for (std::size_t g = 0; g < most / lane_width; ++g) {
      const float left = float(size) - float(g * lane_width);
      mask[g] = (left - Lanes::LinSpaced(0.f, float(lane_width - 1))).max(0.f).min(1.f);
      for (Edge_lanes& lanes : even)
        lanes[g].setZero();
      for (Edge_lanes& lanes : odd)
        lanes[g].setZero();
    }
  }

  static float& at(Edge_lanes& lanes, std::size_t i)
  {
    return lanes[i / lane_width][Eigen::Index(i % lane_width)];
  }

  /// Which one of all neighbors is number `i` here
  static std::size_t spread(const Neighborhood_3& neighborhood, std::size_t i)
  {
    const std::size_t n = neighborhood.size();
    return n > most ? i * n / most : i;
  }

  /// Fills the first two even and odd lanes of each neighbor: its distance in the tangent plane and the angle of the
  /// normals; its height above the tangent plane, and the height of its own plane, in neighborhood radii. The third odd
  /// ones, which are there, are turned where the two normals point to opposite sides.
  void read_edges(const Neighborhood_3& neighborhood)
  {
    const Neighbor_lanes lanes(neighborhood);
    const Neighbor_numbers& all = neighborhood.numbers();
    for (std::size_t g = 0; g < groups(); ++g) {
      const std::size_t first = g * lane_width, left = std::size_t(size) - first;
      const Lane_numbers numbers = lane_numbers([&](std::size_t l) {
        return l < left ? all[spread(neighborhood, first + l)] : neighborhood.center_number();
      });
      const Lanes_3 d = lanes.differences(numbers), normals = lanes.normals(numbers);
      const Lanes cosine = normals * lanes.normal, height = d * lanes.normal;
      const Lanes tangential = roots((d.squared_length() - height * height).max(0.f));
      const Lanes angle = roots((2.f - 2.f * cosine.abs()).max(0.f)); // for small ones
      even[0][g] = (2.f * tangential - 1.f) * mask[g];
      even[1][g] = 1.5f * angle * mask[g];
      odd[0][g] = height;
      odd[1][g] = flipped(d * normals, cosine);
      odd[2][g] = flipped(odd[2][g], cosine);
    }
  }

  /// Close to x, but between -4 and 4
  static float squashed(float x) { return x / std::sqrt(1.f + x * x * (1.f / 16.f)); }
  /// The same of all numbers, in a unit
  static void squash(Edge_lanes& numbers, float unit)
  {
    const float factor = 1.f / unit;
    for (Lanes& lanes : numbers) {
      const Lanes x = lanes * factor;
      lanes = x / roots(1.f + x * x * (1.f / 16.f));
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
