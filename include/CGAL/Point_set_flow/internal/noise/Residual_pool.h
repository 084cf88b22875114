// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_NOISE_RESIDUAL_POOL_H
#define CGAL_POINT_SET_FLOW_INTERNAL_NOISE_RESIDUAL_POOL_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/neighbors/Neighbor_graph.h>
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
  bool trusts_sides = false;    ///< whether the given sides can be trusted
  double of_scans = 0.;         ///< the share of the variance that the scans explain
};

/// One thread's view on the residuals of all samples, pooled over the samples around each.
class Residual_pool {
  const std::vector<Residuals>& m_residuals;
  const Neighbor_graph& m_near;
  std::vector<double> m_variances;

public:
  /// \param near the samples around each sample
  Residual_pool(const std::vector<Residuals>& residuals, const Neighbor_graph& near)
      : m_residuals(residuals), m_near(near)
  {}

  /// The scale around sample `i`, from the first size whose neighborhoods are two-dimensional and
  /// large against the noise found in them; from the last two-dimensional one, if there is none.
  /// \param count how many of the sizes were measured
  /// \param is_large whether the neighborhoods are large enough
  Local_scale scale(std::size_t i, std::size_t count, bool& is_large)
  {
    const double large = 4.; // radius of a neighborhood over the noise in it
    Local_scale scale;
    is_large = false;
    double variance = 0.;
    std::size_t s = 0;
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
    else if (s < Residuals::steady && s + 1 < count && is_two_dimensional(i, s + 1)) {
      // noise stays as the size grows, shape grows
      const double next = pooled_variance(i, s + 1);
      if (next >= 0.)
        variance = (std::max)((4. * variance - next) / 3., 0.);
    }
    const double rounding = 1e-7; // of the sums of the quadrics, in neighborhood radii
    scale.noise = std::sqrt(variance);
    if (scale.noise < rounding * m_residuals[i].radius[s])
      scale.noise = 0.;
    s = (std::max)(s, Residuals::steady);
    while (s > 0 && !(m_residuals[i].radius[s] > 0.))
      --s;
    scale.spacing = m_residuals[i].radius[s] * std::sqrt(CGAL_PI / double(Residuals::sizes[s]));
    return scale;
  }

private:
  /// Whether the number of neighbors grows with the square of the radius: on lines and in columns
  /// of points it does not, and quadrics would fit anything there.
  bool is_two_dimensional(std::size_t i, std::size_t s) const
  {
    double growth = m_residuals[i].growth[s];
    double count = 1.;
    for (std::size_t j = 0; j < m_near.size(i); ++j) {
      const Residuals& other = m_residuals[m_near.neighbors(i)[j]];
      if (other.radius[s] > 0.)
        growth += other.growth[s], count += 1.;
    }
    const double dimension = std::log(2.) * count / growth;
    const double least = 1.5, most = 3.3; // noise that exceeds the spacing fills space
    return dimension > least && dimension < most;
  }

  /// The variance of the noise if neighborhoods of this size hold no shape; negative if it is not known.
  ///
  /// What a third of the samples around are below: noise is everywhere, detail is not.
  double pooled_variance(std::size_t i, std::size_t s)
  {
    m_variances.clear();
    const auto add = [&](const Residuals& residuals) {
      if (residuals.is_measured(s))
        m_variances.push_back(residuals.variance[s]);
    };
    add(m_residuals[i]);
    for (std::size_t j = 0; j < m_near.size(i); ++j)
      add(m_residuals[m_near.neighbors(i)[j]]);
    if (3 * m_variances.size() < m_near.size(i) + 1)
      return -1.;
    const auto tercile = m_variances.begin() + std::ptrdiff_t(m_variances.size() / 3);
    std::nth_element(m_variances.begin(), tercile, m_variances.end());
    // that of the chi-squared distribution, by the approximation of Wilson and Hilferty
    const double freedom = double(Residuals::sizes[s]) - 5., normal_tercile = -.4307;
    const double a = 2. / (9. * freedom), root = 1. - a + normal_tercile * std::sqrt(a);
    return *tercile / (root * root * root);
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_NOISE_RESIDUAL_POOL_H
