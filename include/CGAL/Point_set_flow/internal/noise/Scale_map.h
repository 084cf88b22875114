// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_NOISE_SCALE_MAP_H
#define CGAL_POINT_SET_FLOW_INTERNAL_NOISE_SCALE_MAP_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/fitting/median.h>
#include <CGAL/Point_set_flow/internal/neighbors/Group_search.h>
#include <CGAL/Point_set_flow/internal/neighbors/Neighbor_graph.h>
#include <CGAL/Point_set_flow/internal/neighbors/nearest_points.h>
#include <CGAL/Point_set_flow/internal/noise/Layer_evidence.h>
#include <CGAL/Point_set_flow/internal/noise/Residual_pool.h>
#include <CGAL/Point_set_flow/internal/noise/Certainty.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// The noise and the spacing around each place, from the samples next to it.
class Scale_map {
  Certainty m_certainty;
  const std::vector<std::uint32_t> m_sites; // of the samples
  const Array<Point_3> m_points;            // of the samples
  const Neighbor_tree m_tree;               // of the samples
  std::vector<Local_scale> m_scales;

public:
  static constexpr int number_of_loops = 9;

  /// \param choose called as `choose(certainty)`, chooses the samples; see `choose_samples()`
  template <typename Choose, typename ConcurrencyTag>
  Scale_map(const Neighbor_tree& tree, const Choose& choose, const Array<Vector_3>& sides,
            const Array<std::uint32_t>& scans, const Clearance& clearance,
            Loops<ConcurrencyTag>& loops)
      : m_certainty(clearance), m_sites(choose(m_certainty)),
        m_points(points_at(tree.points(), m_sites)), m_tree(m_points, loops),
        m_scales(m_sites.size())
  {
    const std::size_t pooled = 64; // samples, besides the one in the middle
    const Neighbor_graph near(m_tree, {pooled, 0., {}}, loops);
    const Layer_evidence evidence(tree, m_sites, near, sides, scans, loops);
    std::vector<Residuals> residuals(m_sites.size());
    Array<double> measured(m_sites.size());
    for_each_sample(loops, [&](std::size_t begin, std::size_t end) {
      // those on the other side do not count
      const std::size_t share = sides.empty() ? 1 : 2;
      const Search_options nearest = {share * Residuals::sizes.back()};
      std::size_t i = begin;
      std::vector<Neighbor> neighborhood;
      Group_search(tree, nearest)(
          m_sites.begin() + std::ptrdiff_t(begin), m_sites.begin() + std::ptrdiff_t(end),
          [&](const std::vector<Neighbor>& found) {
            const std::uint32_t site = m_sites[i];
            const bool is_sided = evidence.layers(i).side_trust == Side_trust::TWO_SHEETS;
            measured[i] =
                searched_radius(found.size(), nearest.k,
                                found.empty() ? 0. : std::sqrt(found.back().squared_distance));
            neighborhood.assign(1, {0., site});
            for (const Neighbor& neighbor : found)
              if (!is_sided || sides[neighbor.index] * sides[site] >= 0.)
                neighborhood.push_back(neighbor);
            residuals[i++].measure(tree.points(), neighborhood);
          });
    });
    for_each_sample(loops, [&](std::size_t begin, std::size_t end) {
      Residual_pool pool(residuals, near);
      for (std::size_t i = begin; i < end; ++i) {
        m_scales[i] = pool.scale(i);
        const bool has_two_sheets = m_scales[i].layers.has_two_sheets;
        m_scales[i].layers = evidence.layers(i);
        m_scales[i].layers.has_two_sheets = has_two_sheets;
      }
    });
    steady(near, loops);
    for (std::size_t i = 0; i < m_scales.size(); ++i)
      m_scales[i].noise = evidence.with_registration_error(m_scales[i].noise, i);
    const int poolings = sides.empty() ? 2 : 3; // of residuals, of noise; of what sides are trusted
    m_certainty.check_pools(m_sites, m_points, measured, near, pooled, poolings, loops);
  }

  Scale_map(const Scale_map&) = delete; // the tree knows where the samples are
  Scale_map& operator=(const Scale_map&) = delete;

  /// the numbers of the samples in the point set
  const std::vector<std::uint32_t>& sites() const { return m_sites; }
  /// around each sample
  const std::vector<Local_scale>& scales() const { return m_scales; }

  const Certainty& certainty() const { return m_certainty; }

  /// The distance of a point from a sample
  double distance(const Point_3& p, std::size_t sample) const
  {
    return std::sqrt(squared_distance(p, m_points[sample]));
  }

  /// the median over the samples
  double noise() const { return median_of(&Local_scale::noise); }
  /// the median over the samples
  double spacing() const { return median_of(&Local_scale::spacing); }

  /// The sample that is nearest to each point
  template <typename ConcurrencyTag>
  Array<std::uint32_t> nearest_samples(const Array<Point_3>& points,
                                       Loops<ConcurrencyTag>& loops) const
  {
    return nearest_points(m_tree, points, loops);
  }

private:
  /// Takes sampling error out of the noise: the median over the samples around, unless the noise differs
  /// significantly.
  template <typename ConcurrencyTag>
  void steady(const Neighbor_graph& near, Loops<ConcurrencyTag>& loops)
  {
    const double significant = 1.25;
    std::vector<double> noise(m_scales.size());
    for_each_sample(loops, [&](std::size_t begin, std::size_t end) {
      std::vector<double> around;
      for (std::size_t i = begin; i < end; ++i) {
        const double own = m_scales[i].noise;
        around.assign(1, own);
        for (std::size_t j = 0; j < near.size(i); ++j)
          around.push_back(m_scales[near.neighbors(i)[j]].noise);
        const double usual = median(around);
        noise[i] = own > significant * usual   ? own / significant
                   : own * significant < usual ? own * significant
                                               : usual;
      }
    });
    for (std::size_t i = 0; i < m_scales.size(); ++i)
      m_scales[i].noise = noise[i];
  }

  static Array<Point_3> points_at(const Array<Point_3>& points,
                                  const std::vector<std::uint32_t>& sites)
  {
    Array<Point_3> some;
    for (const std::uint32_t site : sites)
      some.push_back(points[site]);
    return some;
  }

  template <typename ConcurrencyTag, typename Body>
  void for_each_sample(Loops<ConcurrencyTag>& loops, const Body& body) const
  {
    const std::size_t costly = 256; // samples that make a chunk
    loops.for_each_chunk(m_sites.size(), body, costly);
  }

  double median_of(double Local_scale::*member) const
  {
    std::vector<double> values;
    for (const Local_scale& scale : m_scales)
      values.push_back(scale.*member);
    return values.empty() ? 0. : median(values);
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_NOISE_SCALE_MAP_H
