// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_NOISE_SCALE_SAMPLES_H
#define CGAL_POINT_SET_FLOW_INTERNAL_NOISE_SCALE_SAMPLES_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/fitting/median.h>
#include <CGAL/Point_set_flow/internal/fitting/quadric_residual.h>
#include <CGAL/Point_set_flow/internal/neighbors/Neighbor_query.h>
#include <CGAL/Point_set_flow/internal/noise/sample_points.h>
#include <CGAL/number_type_config.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// The noise at samples of a point set, and from these the noise and the spacing of the whole.
///
/// One small neighborhood size cannot tell noise from structure once the noise exceeds the spacing.
/// The noise is measured at several sizes; the first one counts whose neighborhoods are large against
/// the noise found in them.
class Scale_samples {
  static constexpr double large = 4.;       // radius of a neighborhood over the noise in it
  static constexpr std::size_t steady = 48; // the fewest neighbors that give the spacing

  std::vector<std::uint32_t> m_sites;
  Array<Point_3> m_points;
  std::vector<double> m_noises;
  double m_noise = 0., m_spacing = 0.;

public:
  template <typename ConcurrencyTag>
  Scale_samples(const Neighbor_tree& tree, Loops<ConcurrencyTag>& loops)
      : m_sites(sample_points(tree.points(), loops))
  {
    std::vector<std::size_t> sizes = {12, 24, 48, 96, 192};
    while (!sizes.empty() && sizes.back() >= tree.points().size())
      sizes.pop_back();
    if (sizes.empty())
      return;
    std::vector<std::vector<double>> noises(sizes.size(), std::vector<double>(m_sites.size()));
    std::vector<std::vector<double>> radii = noises;
    measure(tree, sizes, noises, radii, loops);
    for (std::size_t i = 0; i < m_sites.size(); ++i) {
      std::size_t s = 0;
      while (s + 1 < sizes.size() && radii[s][i] < large * noises[s][i])
        ++s;
      m_points.push_back(tree.points()[m_sites[i]]);
      m_noises.push_back(noises[s][i]);
    }
    find_medians(sizes, noises, radii);
  }

  /// the numbers of the samples in the point set
  const std::vector<std::uint32_t>& sites() const { return m_sites; }
  /// where they are; empty where there are too few points for quadrics
  const Array<Point_3>& points() const { return m_points; }
  /// the noise at each of `points()`
  const std::vector<double>& noises() const { return m_noises; }
  /// of the whole point set
  double noise() const { return m_noise; }
  /// of the whole point set
  double spacing() const { return m_spacing; }

private:
  template <typename ConcurrencyTag>
  void measure(const Neighbor_tree& tree, const std::vector<std::size_t>& sizes,
               std::vector<std::vector<double>>& noises, std::vector<std::vector<double>>& radii,
               Loops<ConcurrencyTag>& loops) const
  {
    const std::size_t costly = 16; // samples that make a chunk
    const auto measure_chunk = [&](std::size_t begin, std::size_t end) {
      Neighbor_query query(tree, sizes.back());
      std::vector<std::uint32_t> neighbors;
      for (std::size_t i = begin; i < end; ++i) {
        const std::vector<Neighbor>& found = query(m_sites[i]);
        neighbors.assign(1, m_sites[i]);
        for (std::size_t s = 0; s < sizes.size(); ++s) {
          while (neighbors.size() <= sizes[s])
            neighbors.push_back(found[neighbors.size() - 1].index);
          const double radius = std::sqrt(found[sizes[s] - 1].squared_distance);
          radii[s][i] = radius;
          noises[s][i] = radius > 0. ? quadric_residual(tree.points(), neighbors, radius) : 0.;
        }
      }
    };
    loops.for_each_chunk(m_sites.size(), measure_chunk, costly);
  }

  void find_medians(const std::vector<std::size_t>& sizes, std::vector<std::vector<double>>& noises,
                    std::vector<std::vector<double>>& radii)
  {
    std::size_t s = 0;
    double radius = median(radii[0]);
    m_noise = median(noises[0]);
    while (s + 1 < sizes.size() && (radius < large * m_noise || sizes[s] < steady)) {
      const bool wide_enough = radius >= large * m_noise;
      radius = median(radii[++s]);
      if (!wide_enough)
        m_noise = median(noises[s]);
    }
    m_spacing = radius * std::sqrt(CGAL_PI / double(sizes[s]));
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_NOISE_SCALE_SAMPLES_H
