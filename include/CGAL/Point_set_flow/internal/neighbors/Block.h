// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_BLOCK_H
#define CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_BLOCK_H

#include <CGAL/Point_set_flow/internal/neighbors/Neighbor_graph.h>
#include <CGAL/Point_set_flow/internal/order/Point_buffer.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// Points that are smoothed at a time, with their neighbors: all of them, or a block of a large
/// point set with a halo of those that have a say in what becomes of it.
struct Piece {
  Array<Point_3> points;         ///< \f$u\f$; empty as long as it is the reference
  Array<Point_3> reference;      ///< \f$I\f$
  std::vector<char> constrained; ///< empty if no point is
  Neighbor_graph graph;
  std::vector<std::uint32_t> core; ///< the places of the block; empty if all belong to it

  const Array<Point_3>& current_points() const { return points.empty() ? reference : points; }
  std::size_t core_size() const { return core.empty() ? reference.size() : core.size(); }
  std::size_t core_place(std::size_t i) const { return core.empty() ? i : core[i]; }
};

/// How to search the neighbors
struct Search_options {
  std::size_t k;
  double radius; ///< 0: no limit
};

/// Takes blocks with their halos out of a point set.
///
/// A halo is made of rings: the neighbors of the block, their neighbors, and so on. In each stage
/// of the flow a point depends on its neighbors only. So with as many rings as there are stages,
/// the points of the block are the same, to the last bit, as if all points were there.
class Piece_cutter {
  static constexpr std::uint32_t nowhere = (std::numeric_limits<std::uint32_t>::max)();

  const Point_buffer& m_buffer;
  const Neighbor_tree& m_tree; // of the reference
  const Search_options m_search;
  std::vector<std::uint32_t> m_place; // of the sites in the piece

public:
  Piece_cutter(const Point_buffer& buffer, const Neighbor_tree& tree, const Search_options& search)
      : m_buffer(buffer), m_tree(tree), m_search(search), m_place(buffer.size(), nowhere)
  {}

  /// \param core the sites of the block
  template <typename ConcurrencyTag>
  Piece operator()(ConcurrencyTag tag, const std::vector<std::uint32_t>& core, std::size_t rings,
                   Progress& progress, double work)
  {
    std::vector<std::uint32_t> sites = core; // ring by ring
    for (const std::uint32_t site : core)
      m_place[site] = 0;
    Neighbor_graph graph(m_tree, m_search.k);
    std::size_t begin = 0;
    for (std::size_t ring = 0; ring < rings && begin < sites.size(); ++ring) {
      const std::size_t end = sites.size();
      graph.add(tag, m_tree, sites.data() + begin, sites.data() + end, m_search.radius, progress,
                ring == 0 ? work : 0.);
      for (std::size_t i = begin; i < end; ++i)
        for (std::size_t j = 0; j < graph.size(i); ++j) {
          const std::uint32_t neighbor = graph.neighbors(i)[j];
          if (m_place[neighbor] == nowhere) {
            m_place[neighbor] = 0;
            sites.push_back(neighbor);
          }
        }
      // in the order of space, for the search
      std::sort(sites.begin() + std::ptrdiff_t(end), sites.end());
      begin = end;
    }

    // The order of the point set is that of the piece, too: whoever breaks ties by it, or sums up,
    // comes to the same result.
    std::vector<std::uint32_t> sorted = sites;
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t i = 0; i < sorted.size(); ++i)
      m_place[sorted[i]] = static_cast<std::uint32_t>(i);

    Piece piece = {{}, {}, {}, graph.renumbered(sites, m_place), {}};
    for (const std::uint32_t site : sorted) {
      if (!m_buffer.start.empty())
        piece.points.push_back(m_buffer.start[site]);
      piece.reference.push_back(m_buffer.reference[site]);
      if (!m_buffer.constrained.empty())
        piece.constrained.push_back(m_buffer.constrained[site]);
    }
    for (const std::uint32_t site : core)
      piece.core.push_back(m_place[site]);
    for (const std::uint32_t site : sorted)
      m_place[site] = nowhere;
    return piece;
  }
};

/// All points, which are taken from the buffer, in one piece.
template <typename ConcurrencyTag>
Piece take_all(ConcurrencyTag tag, Point_buffer& buffer, const Neighbor_tree& tree,
               const Search_options& search, Progress& progress, double work)
{
  Neighbor_graph graph(tag, tree, search.k, search.radius, progress, work);
  return {std::move(buffer.start),
          std::move(buffer.reference),
          std::move(buffer.constrained),
          std::move(graph),
          {}};
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_BLOCK_H
