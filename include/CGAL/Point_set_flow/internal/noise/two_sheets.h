// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_NOISE_TWO_SHEETS_H
#define CGAL_POINT_SET_FLOW_INTERNAL_NOISE_TWO_SHEETS_H

#include <CGAL/Point_set_flow/internal/fitting/Angle_weight.h>
#include <CGAL/Point_set_flow/internal/fitting/Neighbor_pairs.h>
#include <CGAL/Point_set_flow/internal/neighbors/Neighbor_graph.h>
#include <CGAL/Point_set_flow/internal/neighbors/Surface.h>
#include <CGAL/Point_set_flow/internal/noise/Scale_samples.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

// Where two sheets of a surface are close to each other, the points of both make one thick layer,
// and the distance of the sheets passes for noise. But the distances from the middle of such a
// layer have two peaks, and their kurtosis tells: with the sheets at +-a and the noise s,
//   variance = a^2 + s^2  and  excess kurtosis = -2 a^4 / (a^2 + s^2)^2.

/// Moments of the distances of a point from the tangent planes of its neighborhood
struct Distance_moments {
  double second, fourth; // about the mean

  // cppcheck-suppress uninitMemberVar // those in an `Array` are not initialized on purpose
  Distance_moments() = default;

  /// \param unit the length of 1, to keep fourth powers in the range of `double`
  Distance_moments(const Neighborhood_3& neighborhood, double unit) : second(0.), fourth(0.)
  {
    if (neighborhood.size() < 2)
      return; // no plane

    const Angle_weight angle(neighborhood.noise() / neighborhood.spacing(), 0.);
    const double width = neighborhood.gaussian_width();
    const double near = 1. / (2. * width * width + (std::numeric_limits<double>::min)());
    const Two_by_two two(neighborhood);
    Lanes in_two[5] = {Lanes(0., 0.), Lanes(0., 0.), Lanes(0., 0.), Lanes(0., 0.), Lanes(0., 0.)};
    for (std::size_t j = 0; j < neighborhood.size(); j += 2) {
      const Lanes_3 d = two.differences(j), normals = two.normals(j);
      const Lanes z = d * two.normal, cosine = normals * two.normal;
      const Lanes x = two.mean_height(z, d * normals, cosine) / unit;
      const Lanes tangential = (d.squared_length() - z * z).max(0.);
      Lanes power = bell(tangential * near + angle.exponent(cosine));
      for (Lanes& sum : in_two) {
        sum += power;
        power *= x;
      }
    }
    double sums[5];
    for (int i = 0; i < 5; ++i)
      sums[i] = in_two[i].sum();
    sums[0] -= two.pads();
    if (!(sums[0] > 0.))
      return; // no neighbors
    const double m1 = sums[1] / sums[0], m2 = sums[2] / sums[0], m3 = sums[3] / sums[0];
    second = (std::max)(m2 - m1 * m1, 0.);
    fourth = (std::max)(
        sums[4] / sums[0] - 4. * m1 * m3 + 6. * m1 * m1 * m2 - 3. * m1 * m1 * m1 * m1, 0.);
  }
};

/// Averages over the neighbors: the kurtosis of one neighborhood alone is mostly chance.
template <typename ConcurrencyTag>
void pool(const Neighbor_graph& graph, Array<Distance_moments>& moments, Progress& progress,
          double work)
{
  const std::size_t most = 64; // all over the neighborhood
  Array<Distance_moments> pooled(moments.size());
  const auto average = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t size = graph.size(i), stride = (size + most - 1) / most;
      Distance_moments sum = moments[i];
      double count = 1.;
      for (std::size_t j = 0; j < size; j += stride) {
        sum.second += moments[graph.neighbors(i)[j]].second;
        sum.fourth += moments[graph.neighbors(i)[j]].fourth;
        count += 1.;
      }
      pooled[i].second = sum.second / count;
      pooled[i].fourth = sum.fourth / count;
    }
  };
  for_each_block<ConcurrencyTag>(moments.size(), progress, work, average);
  moments.swap(pooled);
}

/// Finds the noise within the sheets of thin parts, and what neighborhoods suit them.
/// \param state with normals and the noise around each point, which becomes smaller on thin parts
/// \return the number of neighbors that each point should have
template <typename ConcurrencyTag>
Array<std::uint32_t> find_thin_parts(const Array<Point_3>& points, const Neighbor_graph& graph,
                                     double filter_width, const Curvature_defaults& defaults,
                                     Surface_state& state, Progress& progress, double work)
{
  Array<std::uint32_t> sizes(points.size(), static_cast<std::uint32_t>(graph.largest_size()));
  if (!(state.spacing > 0.))
    return sizes;
  const double unit = state.spacing;
  Array<Distance_moments> moments(points.size());
  const auto measure = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      moments[i] = Distance_moments(graph.neighborhood(points, i, filter_width, state.at(i)), unit);
  };
  for_each_block<ConcurrencyTag>(points.size(), progress, .4 * work, measure);
  for (int i = 0; i < 3; ++i)
    pool<ConcurrencyTag>(graph, moments, progress, .15 * work);

  // a flat-topped distribution, or a neighborhood hardly wider than the noise, has a negative
  // excess without having two peaks
  const double chance = .4, certain = .6, few = .4, fewest = 12., clean = .1, noisy = .18;
  const auto suit = [&](std::size_t i) {
    const double variance = moments[i].second;
    double excess = variance > 0. ? moments[i].fourth / (variance * variance) - 3. : 0.;
    if (!std::isfinite(excess)) // moments of distances out of the range of fourth powers
      excess = 0.;
    const auto share = [](double x, double low, double high) {
      return (std::min)((std::max)((x - low) / (high - low), 0.), 1.);
    };
    const double between = std::sqrt(share(-excess, chance, 2.));
    double& noise = state.noise[i];
    if (between > 0.)
      noise = (std::min)(noise, unit * std::sqrt(variance * (1. - between)));

    const double ratio = noise / state.spacing;
    const double size = neighborhood_size(defaults, ratio);
    const double small = few * defaults.size_factor * std::pow(ratio, defaults.size_exponent);
    const double suited = size + share(-excess, chance, certain) * (std::min)(small - size, 0.);
    sizes[i] = static_cast<std::uint32_t>(std::round((std::max)(suited, (std::min)(fewest, size))));
    // noise of a tenth of the spacing may as well be the shape between the points
    noise *= share(ratio, clean, noisy);
  };
  for_each_block<ConcurrencyTag>(points.size(), progress, .15 * work,
                                 [&](std::size_t begin, std::size_t end) {
                                   for (std::size_t i = begin; i < end; ++i)
                                     suit(i);
                                 });
  return sizes;
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_NOISE_TWO_SHEETS_H
