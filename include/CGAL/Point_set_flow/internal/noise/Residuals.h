// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_NOISE_RESIDUALS_H
#define CGAL_POINT_SET_FLOW_INTERNAL_NOISE_RESIDUALS_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/fitting/Quadric_fit.h>
#include <CGAL/Point_set_flow/internal/neighbors/Neighbor_query.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// What quadrics leave of the neighborhoods of one point, size by size.
///
/// One small size cannot tell noise from structure once the noise exceeds the spacing; large ones
/// hold more structure.
struct Residuals {
  static constexpr std::array<std::size_t, 4> sizes = {{12, 24, 48, 96}};
  static constexpr std::size_t steady = 2;   ///< the first size that gives a steady spacing
  static constexpr std::size_t compared = 1; ///< the size at which neighbors are compared

  /// The variance of the noise if the tercile of many is taken; negative if not measured, or if hardly any
  /// places are distinct
  std::array<double, 4> variance;
  std::array<double, 4> radius;
  std::array<double, 4> growth; ///< the logarithm of the radius over that of half of the neighbors
  double gearys_c = -1.;        ///< at the size `compared`; negative if not measured
  double excess_kurtosis = 0.;  ///< at the largest size

  Residuals()
  {
    variance.fill(-1.);
    radius.fill(0.);
    growth.fill(0.);
  }

  bool is_measured(std::size_t s) const { return variance[s] >= 0.; }

  /// Measures all sizes for which there are enough points.
  /// \param neighborhood the point itself and its nearest neighbors, nearest first
  void measure(const Array<Point_3>& points, const std::vector<Neighbor>& neighborhood)
  {
    std::vector<std::uint32_t> members;
    for (std::size_t s = 0; s < sizes.size() && sizes[s] < neighborhood.size(); ++s) {
      while (members.size() <= sizes[s])
        members.push_back(neighborhood[members.size()].index);
      radius[s] = std::sqrt(neighborhood[sizes[s]].squared_distance);
      const double half = neighborhood[sizes[s] / 2].squared_distance;
      growth[s] = half > 0. ? std::log(radius[s] / std::sqrt(half)) : 10.;
      const double m = double(sizes[s] + 1), unknowns = double(Quadric_fit::unknowns);
      const double places = m / number_of_copies(neighborhood, sizes[s]);
      if (places < unknowns + 2.5)
        continue;
      // copies are not independent of each other
      const Quadric_fit fit(points, members, radius[s]);
      const double r = fit.deviation();
      const double v = r * r * ((m - unknowns) / m) * (places / (places - unknowns)) /
                       chi_squared_tercile(m - unknowns);
      variance[s] = v * filled(radius[s], v);
      if (s == compared)
        gearys_c = fit.gearys_c();
      if (s + 1 == sizes.size())
        excess_kurtosis = fit.excess_kurtosis();
    }
  }

private:
  /// What a third of the values of the chi-squared distribution are below, by the degrees of freedom: the
  /// approximation of Wilson and Hilferty
  static double chi_squared_tercile(double freedom)
  {
    const double normal_tercile = -.4307;
    const double a = 2. / (9. * freedom), root = 1. - a + normal_tercile * std::sqrt(a);
    return root * root * root;
  }

  /// By how much noise is underestimated that fills the neighborhoods.
  ///
  /// The nearest points in space are nearer in height, too: the deviation of the residuals, in radii, is
  /// at most .37. Fitted to simulated planes with 12 to 96 neighbors, white and blue noise of the positions:
  /// r = q / (1 + (q / .37)^3)^(1/3), within 3%, with q the true deviation in radii.
  static double filled(double radius, double variance)
  {
    const double limit = .37, most = .7; // beyond, r hardly depends on the noise
    if (!(radius > 0.))
      return 1.;
    const double share = std::pow(std::sqrt(variance) / (limit * radius), 3);
    return std::pow(1. - (std::min)(share, most), -2. / 3.);
  }

  /// How many points are nearly in one place with the point: merging a scan with itself leaves such
  /// groups.
  static double number_of_copies(const std::vector<Neighbor>& neighborhood, std::size_t size)
  {
    const double near = .01; // in neighborhood radii
    const double limit = near * near * neighborhood[size].squared_distance;
    std::size_t copies = 1;
    while (copies <= size && neighborhood[copies].squared_distance <= limit)
      ++copies;
    return double(copies);
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_NOISE_RESIDUALS_H
