// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_SMOOTH_BLOCK_H
#define CGAL_POINT_SET_FLOW_INTERNAL_SMOOTH_BLOCK_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/Block_status.h>
#include <CGAL/Point_set_flow/internal/flow/Halo_check.h>
#include <CGAL/Point_set_flow/internal/smooth_point_set.h>
#include <CGAL/Iterator_range.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_flow {

namespace internal {

/// The distances up to which all points around each point are at hand, in the coordinates of the core.
template <typename Maps, typename Halo, typename ConcurrencyTag>
Array<double> copy_clearance(const Maps& maps, const Frame& frame, const Halo& halo,
                             const Array<Point_3>& points, Loops<ConcurrencyTag>& loops)
{
  // what rounding of coordinates and distances can amount to
  const double relative = std::ldexp(1., -45), absolute = std::ldexp(1., -490);
  typedef typename Maps::Kernel_point_3 Kernel_point_3;
  std::vector<Kernel_point_3> copies;
  copies.reserve(points.size());
  for (auto it = maps.points.begin(); it != maps.points.end(); ++it)
    copies.push_back(get(maps.point_map, *it));
  Array<double> clearance(points.size());
  loops.for_each_chunk(points.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const double distance = double(halo.distance_to_missing(copies[i])) / frame.unit;
      const Point_3& p = points[i];
      const double far = std::abs(p.x()) + std::abs(p.y()) + std::abs(p.z());
      clearance[i] = distance * (1. - relative) - far * relative - absolute;
    }
  });
  return clearance;
}

/// The places of the first points of the input in the result of a block
struct Interior {
  std::vector<std::uint32_t> sites, // ascending
      place_of;                     // for each point, that of its site among these

  Interior(const std::vector<std::uint32_t>& site_of, std::size_t count)
      : sites(site_of.begin(), site_of.begin() + std::ptrdiff_t(count))
  {
    std::sort(sites.begin(), sites.end());
    sites.erase(std::unique(sites.begin(), sites.end()), sites.end());
    place_of.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
      place_of.push_back(static_cast<std::uint32_t>(
          std::lower_bound(sites.begin(), sites.end(), site_of[i]) - sites.begin()));
  }
};

/// Tells the halo where more points must be at hand.
template <typename Maps, typename Halo>
void require_missing(const Maps& maps, const Halo_check& halo_check, const Frame& frame,
                     const std::vector<std::uint32_t>& site_of, std::size_t number_of_sites,
                     Halo& halo)
{
  std::vector<double> radii(number_of_sites, -1.);
  for (const Halo_check::Ball& ball : halo_check.missing())
    radii[ball.site] = (std::max)({radii[ball.site], ball.radius, 0.});
  std::vector<std::pair<typename Maps::Kernel_point_3, double>> balls;
  std::size_t i = 0;
  for (auto it = maps.points.begin(); it != maps.points.end(); ++it, ++i)
    if (radii[site_of[i]] >= 0.) {
      const typename Maps::Kernel_point_3& p = get(maps.point_map, *it);
      const double farther =
          1.01; // than where points may be missing, or else nothing would be added
      balls.emplace_back(p, (std::max)(radii[site_of[i]] * frame.unit,
                                       farther * double(halo.distance_to_missing(p))));
      radii[site_of[i]] = -1.; // once for duplicates
    }
  for (const auto& [center, radius] : balls) // only now: the distances may change
    halo.require(center, radius);
}

/// See `smooth_point_set()`, of which this is the variant for some of the points.
template <typename ConcurrencyTag, typename PointRange, typename Halo, typename NamedParameters>
Block_status smooth_block(PointRange& points, std::size_t block_size, const Coordinate_frame& frame,
                          Halo& halo, const std::optional<unsigned int>& k,
                          const NamedParameters& np)
{
  const Argument_check check("CGAL::Point_set_flow::smooth_block");
  const Flow_parameters parameters = read_parameters(k, np, check);
  const auto flow = value_of(np, internal_np::flow_t(), Balanced_flow());
  const auto curvature = value_of(np, internal_np::curvature_t(), Default_curvature());
  typedef Caller_maps<PointRange, NamedParameters> Maps;
  Maps maps(points, np, check);
  const std::size_t size = std::size_t(std::distance(points.begin(), points.end()));
  if (block_size > size)
    check.refuse("block_size", block_size, "there are only " + std::to_string(size) + " points");
  if (block_size == 0) {
    write_report(Smoothing_report(), np);
    return Block_status::SMOOTHED;
  }
  auto block = make_range(points.begin(), std::next(points.begin(), std::ptrdiff_t(block_size)));
  typedef Caller_maps<decltype(block), NamedParameters> Block_maps;
  Block_maps block_maps(block, np, check);
  const Wanted_results wanted = wanted_results(maps, flow, curvature);
  Loops<ConcurrencyTag> loops(read_callback(np),
                              total_cost(parameters, flow, curvature, wanted, 0));
  try {
    return loops.in_isolation([&] {
      Input input(maps, check, loops, &frame);
      input.points.clearance =
          copy_clearance(maps, input.frame, halo, input.points.reference, loops);
      Analyzed_points analyzed(std::move(input.points), 0, parameters.block_size, loops);
      const Flow_plan plan(analyzed, flow, curvature, parameters, input.frame.unit);
      const std::size_t number_of_sites = analyzed.buffer().size();
      const Interior interior(analyzed.buffer().site_of, block_size);

      const Halo_check is_certain(analyzed, plan.search);
      const std::optional<Flow_result> result = Block_runs(plan, flow, curvature, wanted, loops)
                                                    .run_one(analyzed, interior.sites, is_certain);
      if (!result) {
        require_missing(maps, is_certain, input.frame, analyzed.buffer().site_of, number_of_sites,
                        halo);
        return Block_status::HALO_TOO_SMALL;
      }
      Smoothing_report report = plan.report();
      report.number_of_points = block_size;
      report.number_of_distinct_points = interior.sites.size();
      report.last_movement = result->moved * input.frame.unit;
      if (!std::isfinite(report.last_movement))
        check.diverges();
      Output<Block_maps> output(block_maps, input.frame, *result, interior.place_of, report, check,
                                loops);
      loops.finish();
      output.write();
      write_report(report, np);
      return Block_status::SMOOTHED;
    });
  }
  catch (const Canceled&) {
    return Block_status::CANCELED;
  }
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_SMOOTH_BLOCK_H
