// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_BLOCK_CUTTER_H
#define CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_BLOCK_CUTTER_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/neighbors/Block.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// Takes blocks with their halos out of a point set.
///
/// A halo is made of rings: the neighbors of the interior, their neighbors, and so on. In each stage
/// of the flow a point depends on its neighbors only. So with as many rings as there are stages,
/// the points of the interior are bitwise identical to those that all points together would give.
class Block_cutter {
  static constexpr std::uint32_t nowhere = (std::numeric_limits<std::uint32_t>::max)();

  const Point_buffer& m_buffer;
  const Neighbor_tree& m_tree; // of the reference
  const Array<std::uint32_t>& m_part_of;
  const Search_options& m_search;
  std::vector<std::uint32_t> m_place; // of the sites in the block

public:
  Block_cutter(const Point_buffer& buffer, const Array<std::uint32_t>& part_of,
               const Neighbor_tree& tree, const Search_options& search)
      : m_buffer(buffer), m_tree(tree), m_part_of(part_of), m_search(search),
        m_place(buffer.size(), nowhere)
  {}

  /// \param interior the sites of the block
  template <typename ConcurrencyTag>
  Block operator()(const std::vector<std::uint32_t>& interior, std::size_t rings,
                   Loops<ConcurrencyTag>& loops)
  {
    const auto all_is_certain = [](const auto&...) { return true; };
    return *cut_certain(interior, rings, all_is_certain, loops);
  }

  /// Cuts a block out of points of which some may be missing.
  /// \param is_certain called for each ring, from the interior on: `is_certain(sites, begin, graph, left)`
  /// tells whether the sites from number `begin` on and their neighbors would be the same if no points
  /// were missing. There are `left` rings still to come; those of the last one need no neighbors.
  /// \return nothing if a ring is not certain
  template <typename Is_certain, typename ConcurrencyTag>
  std::optional<Block> cut_certain(const std::vector<std::uint32_t>& interior, std::size_t rings,
                                   const Is_certain& is_certain, Loops<ConcurrencyTag>& loops)
  {
    std::vector<std::uint32_t> sites = interior; // ring by ring
    const std::optional<std::vector<Neighbor_graph>> graphs =
        add_rings(sites, rings, is_certain, loops);
    if (!graphs)
      return std::nullopt;

    // The block keeps the order of the point set, so that ties are broken and sums are taken in the
    // same way.
    std::vector<std::uint32_t> sorted = sites;
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t i = 0; i < sorted.size(); ++i)
      m_place[sorted[i]] = static_cast<std::uint32_t>(i);

    Block block = {{}, {}, {}, joined(*graphs, sites, loops), {}, m_buffer.noise.of(sorted),
                   {}, {}};
    const bool has_start = !m_buffer.start.empty();
    for (const std::uint32_t site : sorted) {
      block.points.push_back((has_start ? m_buffer.start : m_buffer.reference)[site]);
      if (has_start)
        block.reference.push_back(m_buffer.reference[site]);
      block.part_of.push_back(m_part_of[site]);
      if (!m_buffer.constrained.empty())
        block.constrained.push_back(m_buffer.constrained[site]);
      if (!m_buffer.sides.empty())
        block.sides.push_back(m_buffer.sides[site]);
    }
    for (const std::uint32_t site : interior)
      block.interior.push_back(m_place[site]);
    for (const std::uint32_t site : sorted)
      m_place[site] = nowhere;
    return block;
  }

private:
  /// \return the graph of each ring but the last one
  template <typename Is_certain, typename ConcurrencyTag>
  std::optional<std::vector<Neighbor_graph>>
  add_rings(std::vector<std::uint32_t>& sites, std::size_t rings, const Is_certain& is_certain,
            Loops<ConcurrencyTag>& loops)
  {
    for (const std::uint32_t site : sites)
      m_place[site] = 0;
    std::vector<Neighbor_graph> graphs;
    // After a ring that is not certain, the others are looked at nevertheless: what is missing for them is found
    // in the same run.
    bool all_are_certain = true;
    std::size_t begin = 0;
    for (std::size_t ring = 0; ring < rings && begin < sites.size(); ++ring) {
      const std::size_t end = sites.size();
      graphs.emplace_back(m_tree, sites.data() + begin, end - begin, m_search, loops);
      all_are_certain = is_certain(sites, begin, graphs.back(), rings - ring) && all_are_certain;
      for (std::size_t i = begin; i < end; ++i) {
        const Neighbor_numbers near = graphs.back().neighbors(i - begin, sites[i]);
        for (std::size_t j = 0; j < near.size(); ++j)
          if (m_place[near[j]] == nowhere) {
            m_place[near[j]] = 0;
            sites.push_back(near[j]);
          }
      }
      // in the order of space, for the search
      std::sort(sites.begin() + std::ptrdiff_t(end), sites.end());
      begin = end;
    }
    all_are_certain = is_certain(sites, begin, Neighbor_graph(), std::size_t(0)) && all_are_certain;
    if (!all_are_certain)
      return std::nullopt;
    return graphs;
  }

  /// The graphs of all rings in one, of the points in their places
  /// \param sites ring by ring
  template <typename ConcurrencyTag>
  Neighbor_graph joined(const std::vector<Neighbor_graph>& graphs,
                        const std::vector<std::uint32_t>& sites, Loops<ConcurrencyTag>& loops) const
  {
    std::vector<std::uint32_t> number(sites.size()); // in the order of the sites, of each place
    for (std::size_t i = 0; i < sites.size(); ++i)
      number[m_place[sites[i]]] = static_cast<std::uint32_t>(i);
    return Neighbor_graph(
        sites.size(), [](std::size_t) { return 0; }, // not known
        [&](std::size_t begin, std::size_t end, const auto& add) {
          for (std::size_t place = begin; place < end; ++place) {
            std::size_t i = number[place], ring = 0;
            while (ring < graphs.size() && i >= graphs[ring].number_of_points())
              i -= graphs[ring++].number_of_points();
            if (ring == graphs.size())
              continue; // the last ring
            const Neighbor_numbers near = graphs[ring].neighbors(i, sites[number[place]]);
            add(
                place, place, near.size(), [&](std::size_t j) { return m_place[near[j]]; },
                graphs[ring].radius(i));
          }
        },
        loops);
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_BLOCK_CUTTER_H
