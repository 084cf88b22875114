// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_NOISE_LAYER_EVIDENCE_H
#define CGAL_POINT_SET_FLOW_INTERNAL_NOISE_LAYER_EVIDENCE_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/fitting/scan_evidence.h>
#include <CGAL/Point_set_flow/internal/fitting/side_evidence.h>
#include <CGAL/Point_set_flow/internal/neighbors/Neighbor_graph.h>
#include <CGAL/Point_set_flow/internal/neighbors/Neighbor_query.h>
#include <CGAL/Point_set_flow/internal/neighbors/Surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// What the given sides and the numbers of the scans tell of layers around each sample.
class Layer_evidence {
  static constexpr std::size_t size = 48; // of the neighborhoods
  static constexpr double largest = 100.; // a t statistic that is beyond doubt

  struct Evidence {
    double t = 0.; // times the mixture
    double mixture = 0.;
    Vector_3 side = NULL_VECTOR; // the sum of all
    Scan_evidence scans;

    Evidence& operator+=(const Evidence& other)
    {
      t += other.t;
      mixture += other.mixture;
      scans.variance += other.scans.variance;
      scans.share += other.scans.share;
      return *this;
    }
  };
  std::vector<Local_layers> m_layers; // empty if there are neither sides nor scans
  std::vector<double> m_variances;    // that the scans explain

public:
  /// \param sites the samples
  /// \param near the samples around each sample
  /// \param sides, scans of all points; empty if not given
  template <typename ConcurrencyTag>
  Layer_evidence(const Neighbor_tree& tree, const std::vector<std::uint32_t>& sites,
                 const Neighbor_graph& near, const Array<Vector_3>& sides,
                 const Array<std::uint32_t>& scans, Loops<ConcurrencyTag>& loops)
      : m_layers(sides.empty() && scans.empty() ? 0 : sites.size()), m_variances(m_layers.size())
  {
    const std::size_t costly = 64; // samples that make a chunk
    std::vector<Evidence> evidence(m_layers.size());
    const auto look = [&](std::size_t begin, std::size_t end) {
      Neighbor_query query(tree, size);
      std::vector<std::uint32_t> neighbors;
      for (std::size_t i = begin; i < end; ++i) {
        neighbors.clear();
        for (const Neighbor& neighbor : query(sites[i]))
          neighbors.push_back(neighbor.index);
        if (!sides.empty()) {
          look_at_sides(evidence[i], tree.points(), sites[i], neighbors, sides);
          // the two sheets of a wall are no registration error
          const auto is_opposite = [&](std::uint32_t j) { return sides[j] * sides[sites[i]] < 0.; };
          neighbors.erase(std::remove_if(neighbors.begin(), neighbors.end(), is_opposite),
                          neighbors.end());
        }
        if (!scans.empty())
          evidence[i].scans =
              scan_evidence(tree.points(), sites[i], neighbors.data(), neighbors.size(), scans);
      }
    };
    loops.for_each_chunk(m_layers.size(), look, costly);
    const auto pool = [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        Evidence sum = evidence[i];
        for (std::size_t j = 0; j < near.size(i); ++j)
          sum += evidence[near.neighbors(i)[j]];
        const double count = double(near.size(i) + 1);
        if (!sides.empty())
          m_layers[i].side_trust = trust(sum, count);
        m_layers[i].usual_side = Side_3(evidence[i].side);
        m_layers[i].of_scans = float(sum.scans.share / count);
        m_variances[i] = (std::max)(sum.scans.variance, 0.) / count;
      }
    };
    loops.for_each_chunk(m_layers.size(), pool, costly);
  }

  /// What is known around sample `i`
  Local_layers layers(std::size_t i) const
  {
    return m_layers.empty() ? Local_layers() : m_layers[i];
  }

  /// The noise around sample `i`, registration error included: that of a scan that overlaps others in few places
  /// only is less than what is below it in most of them.
  double with_registration_error(double noise, std::size_t i) const
  {
    if (m_layers.empty())
      return noise;
    const double variance = noise * noise;
    return std::sqrt(
        (std::max)(variance, variance * (1. - double(m_layers[i].of_scans)) + m_variances[i]));
  }

private:
  static void look_at_sides(Evidence& evidence, const Array<Point_3>& points, std::size_t site,
                            const std::vector<std::uint32_t>& neighbors,
                            const Array<Vector_3>& sides)
  {
    const Side_evidence of_sides =
        side_evidence(points, site, neighbors.data(), neighbors.size(), sides);
    evidence.mixture = of_sides.mixture;
    evidence.t = of_sides.mixture * (std::min)((std::max)(of_sides.t, -largest), largest);
    for (const std::uint32_t j : neighbors)
      evidence.side = evidence.side + sides[j];
  }

  /// Nothing, if the sides are as mixed as random ones and do not lie apart. The t statistic of random sides is
  /// about 1, in either direction, and so is their mixture.
  static Side_trust trust(const Evidence& sum, double count)
  {
    const double far = 1.6, hardly_mixed = .36; // one of ten is wrong
    if (std::abs(sum.t) > far * sum.mixture)
      return Side_trust::TWO_SHEETS;
    return sum.mixture < hardly_mixed * count ? Side_trust::ONE_SHEET : Side_trust::NONE;
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_NOISE_LAYER_EVIDENCE_H
