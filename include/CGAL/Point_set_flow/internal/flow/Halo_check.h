// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FLOW_HALO_CHECK_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FLOW_HALO_CHECK_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/neighbors/Neighbor_graph.h>
#include <CGAL/Point_set_flow/internal/noise/Analyzed_points.h>
#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// Checks that the rings of a halo are the same as if no points were missing, and finds what else must be
/// at hand if they are not.
class Halo_check {
public:
  struct Ball {
    std::uint32_t site; ///< in its center
    double radius;
  };

private:
  const Analyzed_points& m_points;
  const Search_options& m_search;
  mutable std::vector<Ball> m_missing;

public:
  Halo_check(const Analyzed_points& points, const Search_options& search)
      : m_points(points), m_search(search)
  {}

  /// Where points may be missing, and more of them than would do: rings that come later are guessed.
  const std::vector<Ball>& missing() const { return m_missing; }

  /// See `Block_cutter::cut_certain()`
  bool operator()(const std::vector<std::uint32_t>& sites, std::size_t begin,
                  const Neighbor_graph& graph, std::size_t rings_left) const
  {
    const Scale_map& map = m_points.scale_map();
    const Clearance& clearance = m_points.clearance();
    bool is_certain = true;
    for (std::size_t i = begin; i < sites.size(); ++i) {
      const std::uint32_t site = sites[i], part = m_points.part_of()[site];
      const Point_3& p = m_points.buffer().reference[site];
      const double to_sample = map.distance(p, part);
      const double radius = rings_left == 0 ? 0.
                                            : searched_radius(graph.size(i), m_search.k_of(site),
                                                              graph.radius(i), m_search.radius);
      if (clearance.holds(site, (std::max)(radius, to_sample)) &&
          map.certainty().is_certain(part) && map.certainty().is_certain(p, to_sample))
        continue;
      is_certain = false;
      m_missing.push_back(
          {site, guess(site, graph.size(i), graph.radius(i), to_sample, rings_left)});
    }
    return is_certain;
  }

private:
  /// How far from a site points may have a say in the rings that are left, and in the pools there. 0 for
  /// points far from all others: only the place nearest to them counts, and the rings are guessed there.
  double guess(std::uint32_t site, std::size_t k, double radius, double to_sample,
               std::size_t rings_left) const
  {
    const double poolings = 2., pooled = 65. * 18., far = 8.; // samples, each one of so many points
    const double spacing = m_points.scale_map().scales()[m_points.part_of()[site]].spacing;
    if (spacing > 0. && radius > far * spacing * std::sqrt(double(k + 1) / CGAL_PI))
      return 0.;
    const double ring = radius > 0. ? radius : m_points.clearance().distance(site);
    return ring * (double(rings_left + 1) + poolings * std::sqrt(pooled / double(k + 1))) +
           to_sample;
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FLOW_HALO_CHECK_H
