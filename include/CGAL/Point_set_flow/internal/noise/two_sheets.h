// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_NOISE_TWO_SHEETS_H
#define CGAL_POINT_SET_FLOW_INTERNAL_NOISE_TWO_SHEETS_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/Curvature_defaults.h>
#include <CGAL/Point_set_flow/internal/fitting/plane_distances.h>
#include <CGAL/Point_set_flow/internal/neighbors/Surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

// Where two sheets of a surface are close to each other, the points of both make one thick layer,
// and the distance between the sheets is mistaken for noise. But the distances from the middle of
// such a layer are bimodal, which their kurtosis shows: with the sheets at +-a and the noise s,
//   variance = a^2 + s^2  and  excess kurtosis = -2 a^4 / (a^2 + s^2)^2.

/// Averages over the points around each one: the kurtosis of a single neighborhood is mostly sampling error.
template <typename ConcurrencyTag>
void pool(const Neighbor_graph& graph, Array<Compact_moments>& moments,
          Loops<ConcurrencyTag>& loops)
{
  const std::size_t most = 64; // spread over the neighborhood
  const int rounds = 3;
  Array<Compact_moments> pooled(moments.size());
  const auto average = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Neighbor_numbers near = graph.neighbors(i);
      const std::size_t stride = (near.size() + most - 1) / most;
      Distance_moments sum = moments[i].moments();
      double count = 1.;
      for (std::size_t j = 0; j < near.size(); j += stride) {
        const Distance_moments other = moments[near[j]].moments();
        sum.second += other.second;
        sum.fourth += other.fourth;
        count += 1.;
      }
      pooled[i] = Compact_moments({sum.second / count, sum.fourth / count});
    }
  };
  for (int i = 0; i < rounds; ++i) {
    loops.for_each_chunk(moments.size(), average);
    moments.swap(pooled);
  }
}

/// What suits one point: the noise within its sheet, and the number of neighbors.
struct Sheet_fit {
  double noise;
  std::uint32_t size;
  bool holds_two_sheets; ///< whether the neighbors are those of two sheets

  /// \param moments of the distances from the tangent planes, in spacings
  /// \param found_noise around the point
  /// \param local what suited the points around before
  /// \param is_given whether the noise is known: the caller gave it
  /// \param is_sided whether the neighbors are all on one side: layers are one surface scanned twice
  Sheet_fit(const Distance_moments& moments, double found_noise, const Local_parameters& local,
            const Curvature_defaults& defaults, bool is_given, bool is_sided)
      : noise(found_noise), size(local.size), holds_two_sheets(false)
  {
    const double spacing = local.spacing;
    const auto share = [](double x, double low, double high) {
      return (std::min)((std::max)((x - low) / (high - low), 0.), 1.);
    };
    const double variance = moments.second;
    const double excess = moments.excess();
    // a flat-topped distribution, or a neighborhood hardly wider than the noise, has a negative
    // excess without being bimodal
    const double doubtful = .4, certain = .6;
    const double between = std::sqrt(share(-excess, doubtful, 2.)); // of the variance
    double is_wall =
        is_sided ? 0. : 1.; // or else registration error, as far as the scans explain it
    if (local.layers.of_scans > 0.f && between > 0.)
      is_wall *= 1. - (std::min)(double(local.layers.of_scans) / between, 1.);
    if (is_wall * between > 0. && !is_given)
      noise = (std::min)(noise, spacing * std::sqrt(variance * (1. - is_wall * between)));

    // Around the sample there are two sheets, but the neighbors may still be those of one.
    const double least_bimodal = .2, likely = .5;
    holds_two_sheets = local.layers.has_two_sheets && is_wall > likely && -excess > least_bimodal;

    const double few = .4, fewest = 12.;
    if (local.least_size > fewest)
      return;
    const double ratio = noise / spacing;
    const double usual = defaults.neighborhood_size(ratio);
    const double small = few * defaults.size_factor * std::pow(ratio, defaults.size_exponent);
    const double suited =
        usual + is_wall * share(-excess, doubtful, certain) * (std::min)(small - usual, 0.);
    size = static_cast<std::uint32_t>(std::round((std::max)(suited, (std::min)(fewest, usual))));
  }
};

/// What suits each point
struct Sheets {
  Array<std::uint32_t> sizes; ///< of the neighborhoods
  /// 1 for points on the side to which their normal points, -1 for the others, 0 where neighborhoods do not
  /// hold two sheets
  Array<signed char> sides;
};

inline signed char side_of(double height) { return height > 0. ? 1 : height < 0. ? -1 : 0; }

/// Whether the evidence that an estimator finds is strong enough. A sheet that is overlooked costs more than
/// one that is not there, hence less than even odds; but where the noise is wider than the spacing, a rough surface
/// looks like two sheets more often.
/// \param noise within the sheets, in spacings
inline bool is_likely(const Sheet_evidence& evidence, double noise)
{
  const double wide = 1.2;
  const float least = noise > wide ? -1.f : -2.f; // logarithms of the odds
  const float least_side = 1.f;
  return evidence.two_sheets > least && std::abs(evidence.side) > least_side;
}

/// How the sides that are found agree with those of the neighbors that are known: 1 if they are the same, -1 if
/// they are opposite, since given normals may point into the wall, and 0 if they contradict each other or the
/// side of the point is known itself.
inline int agreement_of_sides(const Surface& surface, std::size_t i)
{
  const Surface_state& state = surface.state;
  if (state.sides.empty())
    return 1;
  const Neighbor_numbers neighbors = surface.graph.neighbors(i);
  std::size_t known = 0, alike = 0;
  for (std::size_t j = 0; j < neighbors.size(); ++j) {
    const std::uint32_t k = neighbors[j];
    if (!state.is_sided(k))
      continue;
    if (state.sheets.empty())
      return 0;
    const double narrow = 0.; // theirs is being reduced
    if (!is_likely(state.sheets[k], narrow))
      continue;
    ++known;
    alike +=
        state.sides[k].vector() * state.normals[k].vector() * double(state.sheets[k].side) > 0.;
  }
  if (state.is_sided(i))
    return 0;
  return 4 * alike >= 3 * known ? 1 : 4 * alike <= known ? -1 : 0;
}

/// The number of loops of `find_moments()` and `fit_sheets()`
constexpr int sheet_loops = 5;

/// Moments of the distances from the tangent planes
/// \param surface with normals
/// \param sides receives on which side of its neighbors each point is, see `Sheets::sides`
template <typename ConcurrencyTag>
Array<Compact_moments> find_moments(const Surface& surface, Array<signed char>& sides,
                                    Loops<ConcurrencyTag>& loops)
{
  const std::size_t n = surface.size();
  Array<Compact_moments> moments(n);
  sides.resize(n);
  loops.for_each_chunk(n, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      double height = 0.;
      moments[i] = surface.state.parameters(i).spacing > 0.
                       ? Compact_moments(Distance_moments(surface.neighborhood(i), height))
                       : Compact_moments();
      sides[i] = side_of(height);
    }
  });
  return moments;
}

/// Finds the noise within the sheets of thin parts, what neighborhoods suit them, and on which of
/// two sheets a point is.
/// \param surface with normals, and the evidence of the estimator if it finds sheets
/// \param moments, sides see `find_moments()`; the moments are pooled
/// \param noise the noise around each point, in spacings; is reduced on thin parts unless the caller gave it
template <typename ConcurrencyTag>
Sheets fit_sheets(const Surface& surface, const Array<Compact_moments>& moments,
                  Array<signed char>&& sides, const Curvature_defaults& defaults,
                  Array<float>& noise, bool is_given, Loops<ConcurrencyTag>& loops)
{
  const std::size_t n = surface.size();
  Sheets sheets{Array<std::uint32_t>(n), std::move(sides)};
  loops.for_each_chunk(n, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Local_parameters& local = surface.state.parameters(i);
      sheets.sizes[i] = local.size;
      bool holds_two_sheets = false;
      if (local.spacing > 0.) {
        const double found = double(noise[i]) * local.spacing;
        const Sheet_fit fit(moments[i].moments(), found, local, defaults, is_given,
                            surface.state.is_sided(i));
        if (fit.noise < found)
          noise[i] = in_spacings(fit.noise, local.spacing);
        sheets.sizes[i] = fit.size;
        holds_two_sheets = fit.holds_two_sheets;
      }
      const float explained = .25f; // by the scans: then layers are a registration error
      if (!surface.state.sheets.empty() && local.layers.of_scans < explained &&
          is_likely(surface.state.sheets[i], double(noise[i]))) {
        holds_two_sheets = true;
        sheets.sides[i] = side_of(double(surface.state.sheets[i].side));
      }
      const int sign = holds_two_sheets ? agreement_of_sides(surface, i) : 0;
      sheets.sides[i] = static_cast<signed char>(sign * sheets.sides[i]);
    }
  });
  return sheets;
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_NOISE_TWO_SHEETS_H
