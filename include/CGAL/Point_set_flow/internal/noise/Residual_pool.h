// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_NOISE_RESIDUAL_POOL_H
#define CGAL_POINT_SET_FLOW_INTERNAL_NOISE_RESIDUAL_POOL_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/fitting/median.h>
#include <CGAL/Point_set_flow/internal/neighbors/Neighbor_graph.h>
#include <CGAL/Point_set_flow/internal/neighbors/Surface.h>
#include <CGAL/Point_set_flow/internal/noise/Residuals.h>
#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// The noise and the spacing around a point
struct Local_scale {
  double noise = 0., spacing = 0.;
  std::uint32_t least_size = 0; ///< the fewest neighbors that spread over the surface; 0 if unknown
  Local_layers layers;
};

/// One thread's view on the residuals of all samples, pooled over the samples around each.
class Residual_pool {
  const std::vector<Residuals>& m_residuals;
  const Neighbor_graph& m_near;
  static constexpr std::size_t enough =
      20;                       // samples, for statistics that are less steady than a variance
  std::vector<double> m_values; // those that are pooled

public:
  /// \param near the samples around each sample
  Residual_pool(const std::vector<Residuals>& residuals, const Neighbor_graph& near)
      : m_residuals(residuals), m_near(near)
  {}

  /// The scale around sample `i`, from the first size whose neighborhoods are two-dimensional and
  /// large against the noise found in them; from the last two-dimensional one, if there is none.
  Local_scale scale(std::size_t i)
  {
    const double large = 2.1; // radius of a neighborhood over the noise in it
    const std::size_t count = Residuals::sizes.size();
    Local_scale scale;
    double variance = 0.;
    std::size_t s = 0;
    bool is_large = false;
    for (std::size_t size = 0; size < count && !is_large; ++size) {
      // also the next one: columns of points seem to fill space before they make a surface
      if (!is_two_dimensional(i, size) || (size + 1 < count && !is_two_dimensional(i, size + 1)))
        continue;
      const double v = pooled_variance(i, size);
      if (v < 0.)
        continue;
      if (scale.least_size == 0)
        scale.least_size = static_cast<std::uint32_t>(Residuals::sizes[size]);
      variance = v;
      s = size;
      is_large = m_residuals[i].radius[size] >= large * std::sqrt(v);
    }
    if (scale.least_size == 0)
      s = count - 1;
    else if (s < Residuals::steady && is_two_dimensional(i, s + 1)) {
      // noise stays as the size grows, shape grows
      const double next = pooled_variance(i, s + 1);
      if (next >= 0.)
        variance = (std::max)((4. * variance - next) / 3., 0.);
    }
    if (s < Residuals::steady)
      variance *= share_of_noise(i);
    const double rounding = 1e-7; // of the sums of the quadrics, in neighborhood radii
    scale.noise = std::sqrt(variance);
    if (scale.noise < rounding * m_residuals[i].radius[s])
      scale.noise = 0.;
    scale.layers.has_two_sheets = scale.noise > 0. && has_two_sheets(i);
    s = (std::max)(s, Residuals::steady);
    while (s > 0 && !(m_residuals[i].radius[s] > 0.))
      --s;
    scale.spacing = m_residuals[i].radius[s] * std::sqrt(CGAL_PI / double(Residuals::sizes[s]));
    return scale;
  }

private:
  /// The samples around sample `i`, without itself
  template <typename Visit>
  void for_each_near(std::size_t i, const Visit& visit) const
  {
    for (std::size_t j = 0; j < m_near.size(i); ++j)
      visit(m_residuals[m_near.neighbors(i)[j]]);
  }

  /// Whether the number of neighbors grows with the square of the radius: on lines and in columns
  /// of points it does not, and quadrics would fit anything there.
  bool is_two_dimensional(std::size_t i, std::size_t s) const
  {
    double growth = m_residuals[i].growth[s];
    double count = 1.;
    for_each_near(i, [&](const Residuals& other) {
      if (other.radius[s] > 0.)
        growth += other.growth[s], count += 1.;
    });
    const double dimension = std::log(2.) * count / growth;
    const double least = 1.5, most = 3.3; // noise that exceeds the spacing fills space
    return dimension > least && dimension < most;
  }

  /// The variance of the noise if neighborhoods of this size hold no shape; negative if it is not known.
  ///
  /// What a third of the samples around are below: noise is everywhere, detail is not.
  double pooled_variance(std::size_t i, std::size_t s)
  {
    m_values.clear();
    const auto add = [&](const Residuals& residuals) {
      if (residuals.is_measured(s))
        m_values.push_back(residuals.variance[s]);
    };
    add(m_residuals[i]);
    for_each_near(i, add);
    if (3 * m_values.size() < m_near.size(i) + 1)
      return -1.;
    const auto tercile = m_values.begin() + std::ptrdiff_t(m_values.size() / 3);
    std::nth_element(m_values.begin(), tercile, m_values.end());
    return *tercile;
  }

  /// The share of noise in the variance of small sizes, 0 to 1, from Geary's C: .72 for smooth shapes without noise, 1.2 to
  /// 1.3 for white noise (the residuals of a fit repel each other), for random and even positions.
  double share_of_noise(std::size_t i)
  {
    const double of_shape = .72, of_noise = 1.2;
    m_values.clear();
    const auto add = [&](const Residuals& residuals) {
      if (residuals.gearys_c >= 0.)
        m_values.push_back(residuals.gearys_c);
    };
    add(m_residuals[i]);
    for_each_near(i, add);
    if (m_values.size() < enough)
      return 1.;
    const double c = median(m_values);
    return (std::min)((std::max)((c - of_shape) / (of_noise - of_shape), 0.), 1.);
  }

  /// Whether the neighborhoods around sample `i` hold two sheets: the residuals of the largest are bimodal, and
  /// the smaller ones hold less of the other sheet.
  ///
  /// With two sheets d apart and the noise s, the excess kurtosis is -2 / (1 + (2 s / d)^2)^2, and -.3 if d is
  /// 1.6 s. That of uniform noise is as low, but its variance does not grow.
  bool has_two_sheets(std::size_t i)
  {
    const double bimodal = -.3, grown = 1.1;
    const std::size_t small = 1, large = Residuals::sizes.size() - 1;
    double excess = 0., count = 0.;
    const auto add = [&](const Residuals& residuals) {
      if (residuals.is_measured(large))
        excess += residuals.excess_kurtosis, count += 1.;
    };
    add(m_residuals[i]);
    for_each_near(i, add);
    if (count < double(enough) || excess > bimodal * count)
      return false;
    const double before = pooled_variance(i, small);
    return before >= 0. && pooled_variance(i, large) > grown * before;
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_NOISE_RESIDUAL_POOL_H
