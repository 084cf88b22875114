// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_NOISE_LAYER_EVIDENCE_H
#define CGAL_POINT_SET_FLOW_INTERNAL_NOISE_LAYER_EVIDENCE_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/fitting/scan_evidence.h>
#include <CGAL/Point_set_flow/internal/fitting/side_evidence.h>
#include <CGAL/Point_set_flow/internal/neighbors/Neighbor_graph.h>
#include <CGAL/Point_set_flow/internal/neighbors/Neighbor_query.h>

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
    double t = 0., is_mixed = 0., of_scans = 0.;
  };
  std::vector<Evidence> m_evidence; // empty if there are neither sides nor scans

public:
  /// \param sites the samples
  /// \param sides, scans of all points; empty if not given
  template <typename ConcurrencyTag>
  Layer_evidence(const Neighbor_tree& tree, const std::vector<std::uint32_t>& sites,
                 const Array<Vector_3>& sides, const Array<std::uint32_t>& scans,
                 Loops<ConcurrencyTag>& loops)
      : m_evidence(sides.empty() && scans.empty() ? 0 : sites.size())
  {
    const std::size_t costly = 64; // samples that make a chunk
    const auto look = [&](std::size_t begin, std::size_t end) {
      Neighbor_query query(tree, size);
      std::vector<std::uint32_t> neighbors;
      for (std::size_t i = begin; i < end; ++i) {
        neighbors.clear();
        for (const Neighbor& neighbor : query(sites[i]))
          neighbors.push_back(neighbor.index);
        if (!sides.empty()) {
          const Side_evidence evidence =
              side_evidence(tree.points(), sites[i], neighbors.data(), neighbors.size(), sides);
          m_evidence[i].t = (std::min)((std::max)(evidence.t, -largest), largest);
          m_evidence[i].is_mixed = evidence.is_mixed ? 1. : 0.;
        }
        if (!scans.empty())
          m_evidence[i].of_scans =
              scan_evidence(tree.points(), sites[i], neighbors.data(), neighbors.size(), scans);
      }
    };
    loops.for_each_chunk(m_evidence.size(), look, costly);
  }

  /// Whether the sides around sample `i` can be trusted: all agree, or those of two sheets lie apart. The
  /// t statistic of random sides is about 1, in either direction.
  /// \param near the samples around each sample
  bool trusts_sides(const Neighbor_graph& near, std::size_t i) const
  {
    if (m_evidence.empty())
      return false;
    const Evidence sum = pooled(near, i);
    const double far = 1.6;
    return sum.is_mixed == 0. || std::abs(sum.t) > far * sum.is_mixed;
  }

  /// The share of the variance of the heights that the scans explain.
  double of_scans(const Neighbor_graph& near, std::size_t i) const
  {
    return m_evidence.empty() ? 0. : pooled(near, i).of_scans / double(near.size(i) + 1);
  }

private:
  Evidence pooled(const Neighbor_graph& near, std::size_t i) const
  {
    Evidence sum = m_evidence[i];
    for (std::size_t j = 0; j < near.size(i); ++j) {
      const Evidence& other = m_evidence[near.neighbors(i)[j]];
      sum.t += other.t;
      sum.is_mixed += other.is_mixed;
      sum.of_scans += other.of_scans;
    }
    return sum;
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_NOISE_LAYER_EVIDENCE_H
