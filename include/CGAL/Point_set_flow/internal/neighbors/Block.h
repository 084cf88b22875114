// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_BLOCK_H
#define CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_BLOCK_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/neighbors/cut_graph.h>
#include <CGAL/Point_set_flow/internal/order/Point_buffer.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// Points that are smoothed at a time, with their neighbors: all of them, or some that follow each
/// other along the curve, with a halo of those on which their result depends.
struct Block {
  Array<Point_3> points;         ///< \f$u\f$
  Array<Point_3> reference;      ///< \f$I\f$; empty if that is where the points start
  std::vector<char> constrained; ///< empty if no point is
  Neighbor_graph graph;
  std::vector<std::uint32_t> interior; ///< without the halo; empty if there is none
  Given_noise noise;                   ///< of each point, if the caller gives it
  Array<std::uint32_t> part_of;        ///< the part of the point set that each point belongs to
  Array<Vector_3> sides;               ///< the given ones; empty if none is known

  bool is_constrained(std::size_t i) const { return !constrained.empty() && constrained[i]; }
  std::size_t interior_size() const { return interior.empty() ? points.size() : interior.size(); }
  std::size_t interior_place(std::size_t i) const { return interior.empty() ? i : interior[i]; }
};

/// All points, which are taken from the buffer, in one block.
inline Block take_all(Point_buffer& buffer, Array<std::uint32_t>& part_of, Neighbor_graph&& graph)
{
  if (buffer.start.empty())
    std::swap(buffer.start, buffer.reference);
  return {std::move(buffer.start),
          std::move(buffer.reference),
          std::move(buffer.constrained),
          std::move(graph),
          {},
          std::move(buffer.noise),
          std::move(part_of),
          std::move(buffer.sides)};
}

/// Some of the points, copied from the buffer, in one block.
inline Block take_some(const Point_buffer& buffer, const Array<std::uint32_t>& part_of,
                       Cut_graph&& cut)
{
  Block block = {
      {}, {}, {}, std::move(cut.graph), std::move(cut.interior), buffer.noise.of(cut.sites),
      {}, {}};
  const auto copy = [&](const auto& from, auto& to) {
    if (from.empty())
      return;
    to.reserve(cut.sites.size());
    for (const std::uint32_t site : cut.sites)
      to.push_back(from[site]);
  };
  copy(buffer.start.empty() ? buffer.reference : buffer.start, block.points);
  if (!buffer.start.empty())
    copy(buffer.reference, block.reference);
  copy(buffer.constrained, block.constrained);
  copy(part_of, block.part_of);
  copy(buffer.sides, block.sides);
  return block;
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_BLOCK_H
