// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BALANCED_FLOW_INTERNAL_RUN_FLOW_H
#define CGAL_BALANCED_FLOW_INTERNAL_RUN_FLOW_H

#include <CGAL/Balanced_flow/internal/Options.h>
#include <CGAL/Balanced_flow/internal/find_scale.h>
#include <CGAL/Balanced_flow/internal/flow_step.h>
#include <CGAL/Balanced_flow/internal/prefilter.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// What the stages cost relative to each other, for the progress.
namespace work {
constexpr double order = 2., scale = .5, graph = 6., prefilter = 1., variation = 1., step = 2.;

inline double total(const Options& options, bool prefiltered)
{
  return order + scale + graph + 2. * variation +
         options.number_of_iterations * (step + (prefiltered ? prefilter + variation : 0.));
}
} // namespace work

/// The diffusivity where the caller gave no K: 1/2 at a crease of the sharpness angle, but not
/// below what the noise alone makes of a typical point.
inline Diffusivity automatic_diffusivity(double sharpness_angle, std::vector<double> variation)
{
  constexpr double above_noise = 2.;
  return Diffusivity::half_at(
      (std::max)(crease_variation(sharpness_angle), above_noise * median(variation)));
}

/// The neighbourhoods in the reference, which serve the whole run: the start may be anything.
template <typename ConcurrencyTag>
Neighbor_graph make_graph(ConcurrencyTag tag, const Point_buffer& buffer, const Options& options,
                          Progress& progress)
{
  const Neighbor_tree tree(tag, buffer.reference);
  const unsigned int k = options.k ? *options.k : find_scale(tag, tree, progress, work::scale).k;
  return Neighbor_graph(tag, tree, k, options.neighbor_radius, progress, work::graph);
}

/// The flow from the first to the last step, on the private copy of the points (Table 1).
/// \param unit the length of 1 in the buffer, in the unit of the data
/// \return the mean movement of the last step, in the unit of the buffer
template <typename ConcurrencyTag, typename Flow, typename Curvature>
double run_flow(ConcurrencyTag, Point_buffer& buffer, const Neighbor_graph& graph,
                const Options& options, double unit, const Flow& flow, const Curvature& curvature,
                Progress& progress)
{
  const std::size_t n = buffer.size();
  const bool prefiltered = Uses_prefilter<Flow>::value;
  Diffusivity g(options.feature_threshold.value_or(0.));
  std::vector<Point_3> filtered(prefiltered ? n : 0), next(n);
  std::vector<double> variation(n);
  double moved = 0.;

  for (unsigned int t = 0; t < options.number_of_iterations; ++t) {
    if (options.update_period != 0 && t != 0 && t % options.update_period == 0)
      buffer.reference = buffer.points; // section 3.2

    if (prefiltered)
      prefilter<ConcurrencyTag>(buffer.points, graph, options.filter_width, filtered, progress,
                                work::prefilter);
    const bool choose_threshold = t == 0 && !options.feature_threshold;
    if (prefiltered || choose_threshold)
      find_variation<ConcurrencyTag>(prefiltered ? filtered : buffer.points, graph,
                                     options.filter_width, curvature, variation, progress,
                                     work::variation);
    if (choose_threshold)
      g = automatic_diffusivity(options.sharpness_angle, variation);

    moved = flow_step<ConcurrencyTag>(buffer, graph, options.filter_width, curvature,
                                      prefiltered ? &variation : nullptr, flow, g,
                                      options.step_length, unit, next, progress, work::step);
    buffer.points.swap(next);
  }
  return moved;
}

/// The normals of the points where they are now; null vectors where there are less than two
/// neighbours, and so no plane.
template <typename ConcurrencyTag, typename Curvature>
std::vector<Vector_3> find_normals(ConcurrencyTag, const Point_buffer& buffer,
                                   const Neighbor_graph& graph, const Options& options,
                                   const Curvature& curvature, Progress& progress)
{
  std::vector<Vector_3> normals(buffer.size(), NULL_VECTOR);
  const auto find = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Neighborhood_3 near = graph.neighborhood(buffer.points, i, options.filter_width);
      if (near.size() >= 2)
        normals[i] = curvature(near).normal;
    }
  };
  for_each_block<ConcurrencyTag>(buffer.size(), progress, work::variation, find);
  return normals;
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_BALANCED_FLOW_INTERNAL_RUN_FLOW_H
