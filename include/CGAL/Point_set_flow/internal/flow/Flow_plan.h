// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FLOW_FLOW_PLAN_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FLOW_FLOW_PLAN_H

#include <CGAL/Point_set_flow/Diffusivity.h>
#include <CGAL/Point_set_flow/internal/noise/Noise_map.h>
#include <CGAL/Point_set_flow/internal/flow/Flow_parameters.h>
#include <CGAL/Point_set_flow/internal/neighbors/Block.h>
#include <CGAL/Point_set_flow/internal/neighbors/Surface.h>
#include <CGAL/Point_set_flow/internal/flow/model_traits.h>
#include <CGAL/Point_set_flow/internal/flow/prefilter.h>
#include <CGAL/Point_set_flow/internal/flow/tangent_planes.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// What the stages cost relative to each other, for the progress.
namespace work {
constexpr double order = 2., tree = 2., scale = .5, noise = .5, graph = 6., prefilter = 1.,
                 planes = 1., thin_parts = 2., shrink = .5, step = 1.;

/// \param uses_normals whether the estimator does
/// \param prefiltered whether the flow is, and the estimator does not use normals
/// \param outputs how many of normals and feature strength are wanted
inline double total(unsigned int number_of_iterations, bool uses_normals, bool prefiltered,
                    int outputs)
{
  const double before = uses_normals ? planes : prefiltered ? prefilter + planes : 0.;
  return order + tree + scale + graph + (uses_normals ? noise + thin_parts + shrink : 0.) +
         number_of_iterations * (before + step) + outputs * planes;
}
} // namespace work

/// What is decided once, for the whole point set, from the parameters and from samples of the data.
template <typename Flow, typename Curvature>
class Flow_plan {
public:
  static constexpr bool uses_normals = Uses_normals<Curvature>::value;
  // an estimator with normals filters by its weights
  static constexpr bool prefiltered = Uses_prefilter<Flow>::value && !uses_normals;

  const Curvature_defaults defaults = Defaults_of<Curvature>::get();
  const unsigned int number_of_iterations, update_period;
  const double step_length;
  const bool is_k_given;
  double filter_width;
  Search_options search;
  Noise_map noise_map;
  Diffusivity diffusivity = Diffusivity(0.), without_noise = diffusivity;

  /// \param unit the length of 1 in the buffer, in the unit of the data
  template <typename ConcurrencyTag>
  Flow_plan(ConcurrencyTag tag, const Point_buffer& buffer, const Neighbor_tree& tree,
            const Curvature& curvature, const Options& options, double unit, Progress& progress)
      : number_of_iterations(options.number_of_iterations.value_or(defaults.number_of_iterations)),
        update_period(options.update_period),
        step_length(options.step_length.value_or(defaults.step_length)),
        is_k_given(options.k.has_value()),
        filter_width(options.filter_width.value_or(defaults.filter_width)),
        noise_map(tag, find_scale(tag, tree, progress, work::scale), progress)
  {
    const double noise = uses_normals ? noise_map.largest() : noise_map.noise();
    const unsigned int suited =
        neighborhood_size(defaults, noise_map.spacing() > 0. ? noise / noise_map.spacing() : 0.);
    search = {options.k.value_or(suited), 0.};
    if (options.neighbor_radius > 0.) // not 0 in the buffer, which would be no limit
      search.radius =
          (std::max)(options.neighbor_radius / unit, (std::numeric_limits<double>::min)());
    // of too few neighbors each one counts, near or not
    if (uses_normals && !options.filter_width && search.k < suited)
      filter_width *= double(suited) / double(search.k);

    if (options.feature_threshold)
      diffusivity = without_noise = Diffusivity(*options.feature_threshold);
    else {
      const double above_noise = 2.; // a feature has more than the noise makes of any point
      const double noise_variation =
          above_noise * typical_variation(tag, buffer, tree, curvature, progress);
      const double crease =
          crease_variation(options.sharpness_angle.value_or(defaults.sharpness_angle));
      diffusivity = Diffusivity::half_at((std::max)(crease, noise_variation));
      without_noise = Diffusivity::half_at(crease);
    }
  }

  /// How many rings of neighbors around a point have a say in what becomes of it.
  std::size_t number_of_rings() const
  {
    const std::size_t outputs = 1;
    return uses_normals ? 2 * std::size_t(number_of_iterations) + 3 + outputs
                        : (prefiltered ? 2 : 1) * std::size_t(number_of_iterations) + outputs;
  }

private:
  /// The median variation of the surface in the first step, over a sample of points
  template <typename ConcurrencyTag>
  double typical_variation(ConcurrencyTag tag, const Point_buffer& buffer,
                           const Neighbor_tree& tree, const Curvature& curvature,
                           Progress& progress) const
  {
    const std::size_t rings = prefiltered ? 2 : 1;
    Piece piece = Piece_cutter(buffer, tree, search)(tag, noise_map.samples(), rings, progress, 0.);
    Surface_state state;
    state.spacing = noise_map.spacing();
    if (uses_normals)
      state.noise = noise_map.noise_at(tag, piece.reference, progress, 0.);
    if (prefiltered) {
      Array<Point_3> filtered(piece.reference.size());
      prefilter<ConcurrencyTag>(piece.current_points(), piece.graph, filter_width, filtered,
                                progress, 0.);
      piece.points.swap(filtered);
    }
    Array<double> variation(piece.reference.size());
    std::vector<double> of_chosen;
    find_tangent_planes<ConcurrencyTag>(piece.current_points(), piece.graph, filter_width, state,
                                        curvature, nullptr, variation, progress, 0.);
    for (const std::uint32_t i : piece.core)
      of_chosen.push_back(variation[i]);
    return of_chosen.empty() ? 0. : median(of_chosen);
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FLOW_FLOW_PLAN_H
