// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FLOW_RELAXATION_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FLOW_RELAXATION_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/fitting/Same_side.h>
#include <CGAL/Point_set_flow/internal/fitting/Tangent_moments.h>
#include <CGAL/Point_set_flow/internal/neighbors/Surface.h>

#include <CGAL/number_type_config.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// Moves points along the surface that the smoothed points and their normals define, so that they spread
/// evenly over it.
///
/// In its tangent plane a point is repelled by neighbors that are nearer than usual; then it is projected
/// back to the surface. Neighbors behind a crease or on another sheet do not count, so that a crease is a
/// border to both of its sides. From a border no point is pushed outwards, and points in a line stay.
class Relaxation {
  // lengths in spacings
  static constexpr double reach = 1.35,  // of the repulsion
      strength = .4,                     // the step away from a single neighbor in the same place
      longest_step = .35, farthest = 1., // of one step, and of all together
      border_radius = 3., line_radius = 2., // how far to look for them
      projection_width = .6, sheet_width = .6;
  static constexpr double angle_width = .42; // radians between normals
  // How far the mean of the points around is off, in the radius up to which they count: .34 at a straight
  // border, .28 at that of a lattice, and .15 for one of seven points where they are random.
  static constexpr double least_offset = .15, border_offset = .28;
  // The aspect of the points around, the smaller of their second moments as a share of the larger one: up to the
  // first one they are in a line
  static constexpr double line_aspect = .05, surface_aspect = .2;
  static constexpr double largest_exponent = 7.; // of weights that matter
  // A point's own spacing, with a margin for its scatter, counts where it is less than that of the part:
  // beside a coarser region
  static constexpr double margin = 1.1;

  struct Sheet_neighbor {
    std::uint32_t index;
    double weight; ///< 1 if it is surely on the same sheet, and on the same side of a crease
  };
  typedef boost::container::small_vector<Sheet_neighbor, 128> Sheet;

  const Surface& m_surface; // as it was before the first step

public:
  /// \pre the normals of the surface are known
  explicit Relaxation(const Surface& surface) : m_surface(surface) {}

  /// Where a point moves.
  /// \param points where all points are before the step
  Point_3 operator()(const Array<Point_3>& points, std::size_t i) const
  {
    const Neighborhood_3 all = m_surface.neighborhood(i);
    if (all.is_sided())
      return moved(Same_side(all).neighborhood(), points, i);
    return moved(all, points, i);
  }

private:
  Point_3 moved(const Neighborhood_3& neighborhood, const Array<Point_3>& points,
                std::size_t i) const
  {
    if (neighborhood.size() < 2 || !(neighborhood.spacing() > 0.) || !(neighborhood.radius() > 0.))
      return points[i];
    const Sheet sheet = find_sheet(neighborhood);
    double spacing = neighborhood.spacing();
    const Point_3& start = neighborhood.center();
    const Point_3 pushed = points[i] + repulsion(neighborhood, sheet, points, i, spacing);
    // even with few neighbors, points stay well within their neighborhoods
    const double limit = (std::min)(farthest * spacing, .5 * neighborhood.radius());
    return projected(start + not_longer(pushed - start, limit), neighborhood, sheet, spacing);
  }

  static Vector_3 not_longer(const Vector_3& v, double length)
  {
    const double l = std::sqrt(v.squared_length());
    return l > length ? v * (length / l) : v;
  }

  /// 0 up to `from`, 1 from `to` on
  static double ramp(double x, double from, double to)
  {
    return (std::min)((std::max)((x - from) / (to - from), 0.), 1.);
  }

  /// The neighbors on the same sheet that are near enough to matter
  static Sheet find_sheet(const Neighborhood_3& neighborhood)
  {
    Sheet sheet;
    const Point_3& center = neighborhood.center();
    const Vector_3 normal = neighborhood.normal();
    const double spacing = neighborhood.spacing(), far = (border_radius + 2. * farthest) * spacing;
    const double by_height = 1. / (2. * sheet_width * sheet_width * spacing * spacing);
    const double by_angle = 2. / (angle_width * angle_width); // 1 - cos is half the squared angle
    for (std::size_t j = 0; j < neighborhood.size(); ++j) {
      const Vector_3 d = neighborhood[j] - center;
      if (d.squared_length() > far * far)
        continue;
      const double cosine = neighborhood.normal(j) * normal;
      const double angle = (1. - std::abs(cosine)) * by_angle;
      const double height =
          .5 * (d * normal + std::copysign(1., cosine) * (d * neighborhood.normal(j)));
      const double exponent = angle * angle + height * height * by_height;
      if (exponent < largest_exponent)
        sheet.push_back({neighborhood.numbers()[j], std::exp(-exponent)});
    }
    return sheet;
  }

  /// The step of a point away from neighbors that are too near.
  /// \param spacing becomes less where the points are denser than usual
  static Vector_3 repulsion(const Neighborhood_3& neighborhood, const Sheet& sheet,
                            const Array<Point_3>& points, std::size_t i, double& spacing)
  {
    const Vector_3 normal = neighborhood.normal();
    const double radius = (std::min)(border_radius * spacing, neighborhood.radius());
    const double near = (std::min)(line_radius * spacing, neighborhood.radius());
    boost::container::small_vector<Vector_3, 128> differences; // in the tangent plane
    Tangent_moments moments;
    Vector_3 offset = NULL_VECTOR;
    double weights = 0.;
    for (const Sheet_neighbor& j : sheet) {
      const Vector_3 d = points[j.index] - points[i], tangential = d - (d * normal) * normal;
      differences.push_back(tangential);
      const double squared_length = tangential.squared_length();
      const double weight = j.weight * (std::max)(1. - squared_length / (radius * radius), 0.);
      weights += weight;
      offset = offset + weight * tangential;
      moments.add(j.weight * (std::max)(1. - squared_length / (near * near), 0.), tangential);
    }
    // a disc with n points for each of its unit squares has n pi / 2 radius^2 such weights
    spacing = (std::min)(spacing, margin * radius * std::sqrt(CGAL_PI / (2. * (1. + weights))));

    const double farthest_pushing = reach * spacing;
    Vector_3 step = NULL_VECTOR;
    for (std::size_t j = 0; j < sheet.size(); ++j) {
      const double squared_distance = differences[j].squared_length();
      if (!(squared_distance > 0.) || squared_distance > farthest_pushing * farthest_pushing)
        continue;
      const double distance = std::sqrt(squared_distance);
      const double nearness = 1. - distance / farthest_pushing;
      step = step - (sheet[j].weight * nearness / distance) * differences[j];
    }
    if (weights > 0.)
      step = not_beyond_border(step, offset / (weights * radius));
    const double spread =
        ramp(moments.aspect(), line_aspect, surface_aspect); // how far they are a surface
    return not_longer(step * (spread * strength * spacing), longest_step * spacing);
  }

  /// Without the part that points outwards, if there is a border.
  /// \param offset of the mean of the neighbors, in the radius up to which they count
  static Vector_3 not_beyond_border(const Vector_3& step, const Vector_3& offset)
  {
    const double length = std::sqrt(offset.squared_length());
    if (!(length > least_offset) || step * offset >= 0.)
      return step;
    const double share = ramp(length, least_offset, border_offset);
    return step - (share * (step * offset) / (length * length)) * offset;
  }

  /// Projects a place near the point to the surface around, by the distances \f$d_j\f$ along both normals.
  Point_3 projected(const Point_3& q, const Neighborhood_3& neighborhood, const Sheet& sheet,
                    double spacing) const
  {
    const double width = projection_width * spacing, by_distance = 1. / (2. * width * width);
    Vector_3 normals = NULL_VECTOR, differences = NULL_VECTOR;
    double weights = 0., heights = 0.;
    const auto add = [&](const Point_3& p, const Vector_3& normal, double sheet_weight) {
      const Vector_3 d = q - p;
      const double exponent = d.squared_length() * by_distance;
      if (exponent > largest_exponent)
        return;
      const double weight = sheet_weight * std::exp(-exponent);
      const double sided = std::copysign(weight, normal * neighborhood.normal());
      normals = normals + sided * normal;
      differences = differences + weight * d;
      heights += sided * (d * normal);
      weights += weight;
    };
    add(neighborhood.center(), neighborhood.normal(), 1.);
    for (const Sheet_neighbor& j : sheet)
      add(m_surface.points[j.index], m_surface.state.normals[j.index].vector(), j.weight);
    const double length = std::sqrt(normals.squared_length());
    if (!(length > 0.)) // nothing is near, or there are no normals
      return q;
    const Vector_3 normal = normals / length; // of the surface at q
    return q - (.5 * (differences * normal + heights) / weights) * normal;
  }
};

/// Moves points along the surface, all of them at once in each step.
/// \param surface where the points are, with their normals; not where `points` is, which move
/// \param may_move tells it for each point
template <typename ConcurrencyTag, typename May_move>
void relax_along_surface(const Surface& surface, unsigned int number_of_steps,
                         const May_move& may_move, Array<Point_3>& points,
                         Loops<ConcurrencyTag>& loops)
{
  const Relaxation relaxation(surface);
  Array<Point_3> before(points.size());
  for (unsigned int t = 0; t < number_of_steps; ++t) {
    before.swap(points);
    loops.begin_stage(stage_costs::relaxation);
    loops.for_each_chunk(before.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        points[i] = may_move(i) ? relaxation(before, i) : before[i];
    });
  }
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FLOW_RELAXATION_H
