// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_SURFACE_H
#define CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_SURFACE_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/Diffusivity.h>
#include <CGAL/Point_set_flow/Side_3.h>
#include <CGAL/Point_set_flow/Tangent_plane_3.h>
#include <CGAL/Point_set_flow/internal/neighbors/Neighbor_graph.h>
#include <CGAL/Point_set_flow/internal/parallel/Vector_array.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// How far the given sides can be trusted around a sample
enum class Side_trust : std::uint8_t {
  NONE,
  ONE_SHEET, ///< nearly all sides agree; those that do not are wrong
  TWO_SHEETS ///< opposite sides are those of two sheets that lie apart
};

/// What is known of layers around a sample
struct Local_layers {
  Side_trust side_trust = Side_trust::NONE;
  bool has_two_sheets = false; ///< whether the largest neighborhoods hold those of two sheets
  Side_3 usual_side;           ///< the given side of most points
  float of_scans = 0.f;        ///< the share of the variance that the scans explain
};

/// What suits the points around a sample, which make a part of the point set
struct Local_parameters {
  double noise, spacing;
  std::uint32_t size;       ///< of the neighborhoods
  std::uint32_t least_size; ///< smaller ones do not spread over the surface
  double filter_width;      ///< of the Gaussians, in neighborhood radii
  Local_layers layers;
  Diffusivity diffusivity = Diffusivity(0.);
};

/// A length in spacings, in the range of `float`; 0 if the spacing is 0
inline float in_spacings(double length, double spacing)
{
  const double most = double((std::numeric_limits<float>::max)());
  return spacing > 0. ? float((std::min)(length / spacing, most)) : 0.f;
}

/// What is known of a surface besides its points, at one time of the flow.
struct Surface_state {
  Vector_array normals;         ///< empty before the first ones
  Array<float> variations;      ///< of the same tangent planes
  Array<float> noise;           ///< around each point, in spacings; empty if not needed
  Array<std::uint32_t> part_of; ///< for each point, the part that it belongs to
  const std::vector<Local_parameters>& parts;
  double time = 0.;                  ///< 0 in the first step, 1 in the last
  Array<Side_3> sides;               ///< given or found; empty if none is known
  Array<Sheet_evidence> sheets = {}; ///< empty if not needed
  /// what the flow took off, along the normals, in neighborhood radii; empty if not needed
  Array<float> residuals = {};

  /// Whether the side of a point is known: its neighbors on the opposite side are another sheet then, and
  /// layers on its own side are one surface scanned twice.
  bool is_sided(std::size_t i) const { return !sides.empty() && sides[i].is_known(); }

  /// The normal of a point oriented to its side.
  Vector_3 oriented(std::size_t i, const Vector_3& normal) const
  {
    return !sides.empty() && sides[i].vector() * normal < 0. ? -normal : normal;
  }

  /// \pre the tangent planes are known
  Tangent_plane_3 plane(std::size_t i) const
  {
    return {normals[i].vector(), double(variations[i])};
  }

  const Local_parameters& parameters(std::size_t i) const { return parts[part_of[i]]; }

  /// Tells what is known around a point.
  void describe(std::size_t i, Surface_estimate_3& surface) const
  {
    surface.normals = normals.empty() ? nullptr : normals.data();
    surface.spacing = parameters(i).spacing;
    surface.noise = noise.empty() ? 0. : double(noise[i]) * surface.spacing;
    surface.time = time;
    surface.sides = sides.empty() ? nullptr : sides.data();
    surface.sheets = sheets.empty() ? nullptr : sheets.data();
    surface.residuals = residuals.empty() ? nullptr : residuals.data();
  }
};

/// A view on points at one time of the flow, with their neighbors and what else is known
struct Surface {
  const Array<Point_3>& points;
  const Neighbor_graph& graph;
  const Surface_state& state;
  double narrowing = 1.; ///< of the Gaussians

  std::size_t size() const { return points.size(); }
  bool is_isolated(std::size_t i) const
  {
    // most neighborhoods are too small for that: a look at the neighbors' would cost more
    const double spacing = state.parameters(i).spacing, radius = graph.radius(i);
    return radius * radius > double(graph.size(i)) * spacing * spacing && graph.is_isolated(i);
  }
  Neighborhood_3 neighborhood(std::size_t i) const
  {
    Neighborhood_3 neighborhood =
        graph.neighborhood(points, i, narrowing * state.parameters(i).filter_width);
    state.describe(i, neighborhood.surface_estimate());
    return neighborhood;
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_SURFACE_H
