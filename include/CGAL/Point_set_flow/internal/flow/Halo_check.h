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

  /// See `cut_graph()`
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
      // the last ring needs no neighbors, and has none in the graph
      const double found = rings_left == 0 ? 0. : graph.radius(i - begin);
      const double radius =
          rings_left == 0
              ? 0.
              : searched_radius(graph.size(i - begin), m_search.k_of(site), found, m_search.radius);
      if (clearance.holds(site, (std::max)(radius, to_sample)) &&
          map.certainty().is_certain(part) && map.certainty().is_certain(p, to_sample))
        continue;
      is_certain = false;
      m_missing.push_back({site, guess(site, found, rings_left, to_sample)});
    }
    return is_certain;
  }

private:
  /// How far from a site the result may depend on points in the rings that are left, and in the pools there. 0 for
  /// points far from all others: only the place nearest to them counts, and the rings are guessed there.
  /// \param radius of its neighborhood; 0 if not known
  double guess(std::uint32_t site, double radius, std::size_t rings_left, double to_sample) const
  {
    const double poolings = 3., pooled = 65. * 18., far = 8.; // samples, each one of so many points
    const double spacing = m_points.scale_map().scales()[m_points.part_of()[site]].spacing;
    const double k = double(m_search.k_of(site)), usual = spacing * std::sqrt((k + 1.) / CGAL_PI);
    if (usual > 0. && radius > far * usual)
      return 0.;
    const double clearance = m_points.clearance().distance(site), farther = 1.2;
    const double ring = radius > 0. ? radius : usual > 0. ? usual : clearance;
    const double ahead = ring * (double(rings_left + 1) + poolings * std::sqrt(pooled / (k + 1.)));
    return (std::max)(ahead + to_sample, farther * clearance);
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FLOW_HALO_CHECK_H
