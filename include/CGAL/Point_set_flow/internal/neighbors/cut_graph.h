// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_CUT_GRAPH_H
#define CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_CUT_GRAPH_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/neighbors/Neighbor_graph.h>
#include <CGAL/Point_set_flow/internal/neighbors/Site_set.h>
#include <CGAL/Point_set_flow/internal/parallel/stage_costs.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// Some points with a halo around them, and their neighbors.
///
/// A halo is made of rings: the neighbors of the interior, their neighbors, and so on. If a point depends on its
/// neighbors only in each of as many stages as there are rings, the results in the interior are bitwise identical to
/// those that all points together would give.
struct Cut_graph {
  std::vector<std::uint32_t>
      sites; ///< of all points, ascending: ties are broken and sums are taken as among all
  std::vector<std::uint32_t> interior; ///< the places of the interior among them
  Neighbor_graph graph;                ///< of the points in their places; none for the last ring
};

/// The graphs of all rings in one, of the points in their places
/// \param sites ring by ring
template <typename ConcurrencyTag>
Neighbor_graph joined_graph(const std::vector<Neighbor_graph>& graphs,
                            const std::vector<std::uint32_t>& sites, const Site_set& set,
                            Loops<ConcurrencyTag>& loops)
{
  std::vector<std::uint32_t> number(sites.size()); // in the order of the sites, of each place
  for (std::size_t i = 0; i < sites.size(); ++i)
    number[set.place(sites[i])] = static_cast<std::uint32_t>(i);
  return Neighbor_graph(
      sites.size(), [](std::size_t) { return std::size_t(0); }, // not known
      [&](std::size_t begin, std::size_t end, const auto& add) {
        for (std::size_t place = begin; place < end; ++place) {
          std::size_t i = number[place], ring = 0;
          while (ring < graphs.size() && i >= graphs[ring].number_of_points())
            i -= graphs[ring++].number_of_points();
          if (ring == graphs.size())
            continue; // the last ring
          const Neighbor_numbers near = graphs[ring].neighbors(i, sites[number[place]]);
          add(
              place, place, near.size(), [&](std::size_t j) { return set.place(near[j]); },
              graphs[ring].radius(i));
        }
      },
      loops);
}

/// Cuts points with their halo out of a point set of which some may be missing.
/// \param interior the sites of the points
/// \param is_certain called for each ring, from the interior on: `is_certain(sites, begin, graph, left)`
/// tells whether the sites from number `begin` on and their neighbors would be the same if no points
/// were missing. There are `left` rings still to come; those of the last one need no neighbors.
/// \return nothing if a ring is not certain
template <typename Is_certain, typename ConcurrencyTag>
std::optional<Cut_graph> cut_graph(const Neighbor_tree& tree, const Search_options& search,
                                   const std::vector<std::uint32_t>& interior, std::size_t rings,
                                   const Is_certain& is_certain, Loops<ConcurrencyTag>& loops)
{
  Site_set set(tree.points().size());
  std::vector<std::uint32_t> sites = interior; // ring by ring
  for (const std::uint32_t site : sites)
    set.insert(site);
  std::vector<Neighbor_graph> graphs; // of each ring but the last one
  // After a ring that is not certain, the others are looked at nevertheless: what is missing for them is found
  // in the same run.
  bool all_are_certain = true;
  std::size_t begin = 0;
  for (std::size_t ring = 0; ring < rings && begin < sites.size(); ++ring) {
    const std::size_t end = sites.size();
    graphs.emplace_back(tree, sites.data() + begin, end - begin, search, loops);
    all_are_certain = is_certain(sites, begin, graphs.back(), rings - ring) && all_are_certain;
    for (std::size_t i = begin; i < end; ++i) {
      const Neighbor_numbers near = graphs.back().neighbors(i - begin, sites[i]);
      for (std::size_t j = 0; j < near.size(); ++j)
        if (set.insert(near[j]))
          sites.push_back(near[j]);
    }
    // in the order of space, for the search
    std::sort(sites.begin() + std::ptrdiff_t(end), sites.end());
    begin = end;
  }
  all_are_certain = is_certain(sites, begin, Neighbor_graph(), std::size_t(0)) && all_are_certain;
  if (!all_are_certain)
    return std::nullopt;

  Cut_graph cut;
  cut.sites = set.finish();
  cut.graph = joined_graph(graphs, sites, set, loops);
  cut.interior.reserve(interior.size());
  for (const std::uint32_t site : interior)
    cut.interior.push_back(set.place(site));
  return cut;
}

/// The same of a point set of which none are missing
template <typename ConcurrencyTag>
Cut_graph cut_graph(const Neighbor_tree& tree, const Search_options& search,
                    const std::vector<std::uint32_t>& interior, std::size_t rings,
                    Loops<ConcurrencyTag>& loops)
{
  const auto all_is_certain = [](const auto&...) { return true; };
  return *cut_graph(tree, search, interior, rings, all_is_certain, loops);
}

/// Cuts all points out of a point set, block by block along the curve. Each cut is a stage of the progress.
/// \param visit called as `visit(cut, begin, end)` for the sites from `begin` to `end`, which are the interior
template <typename ConcurrencyTag, typename Visit>
void for_each_cut(const Neighbor_tree& tree, const Search_options& search, std::size_t block_size,
                  std::size_t rings, const Visit& visit, Loops<ConcurrencyTag>& loops)
{
  const std::size_t n = tree.points().size();
  for (std::size_t begin = 0; begin < n; begin += block_size) {
    const std::size_t end = (std::min)(begin + block_size, n);
    std::vector<std::uint32_t> interior(end - begin);
    std::iota(interior.begin(), interior.end(), static_cast<std::uint32_t>(begin));
    loops.set_share(double(end - begin) / double(n));
    loops.begin_stage(stage_costs::graph);
    visit(cut_graph(tree, search, interior, rings, loops), begin, end);
  }
  loops.set_share(1.);
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_CUT_GRAPH_H
