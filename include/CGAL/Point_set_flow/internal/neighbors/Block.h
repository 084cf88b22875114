// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_BLOCK_H
#define CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_BLOCK_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/neighbors/Neighbor_graph.h>
#include <CGAL/Point_set_flow/internal/order/Point_buffer.h>
#include <CGAL/Point_set_flow/internal/parallel/Loops.h>

#include <algorithm>
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
  Array<Point_3> points;         ///< \f$u\f$; empty as long as it is the reference
  Array<Point_3> reference;      ///< \f$I\f$
  std::vector<char> constrained; ///< empty if no point is
  Neighbor_graph graph;
  std::vector<std::uint32_t> interior; ///< without the halo; empty if there is none
  Given_noise noise;                   ///< of each point, if the caller gives it
  Array<std::uint32_t> part_of;        ///< the part of the point set that each point belongs to
  Array<Vector_3> sides;               ///< the given ones; empty if none is known

  const Array<Point_3>& current_points() const { return points.empty() ? reference : points; }
  /// Where the points start is allocated when it is first needed, to save memory.
  template <typename ConcurrencyTag>
  void allocate_points(Loops<ConcurrencyTag>& loops)
  {
    if (!points.empty())
      return;
    points.resize(reference.size());
    loops.for_each_chunk(points.size(), [&](std::size_t begin, std::size_t end) {
      std::copy(reference.begin() + std::ptrdiff_t(begin), reference.begin() + std::ptrdiff_t(end),
                points.begin() + std::ptrdiff_t(begin));
    });
  }
  /// The vector from a point back to its reference point
  Vector_3 forcing(std::size_t i) const
  {
    return points.empty() ? Vector_3(NULL_VECTOR) : reference[i] - points[i];
  }
  bool is_constrained(std::size_t i) const { return !constrained.empty() && constrained[i]; }
  std::size_t interior_size() const
  {
    return interior.empty() ? reference.size() : interior.size();
  }
  std::size_t interior_place(std::size_t i) const { return interior.empty() ? i : interior[i]; }
};

/// All points, which are taken from the buffer, in one block.
inline Block take_all(Point_buffer& buffer, Array<std::uint32_t>& part_of, Neighbor_graph&& graph)
{
  return {std::move(buffer.start),
          std::move(buffer.reference),
          std::move(buffer.constrained),
          std::move(graph),
          {},
          std::move(buffer.noise),
          std::move(part_of),
          std::move(buffer.sides)};
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_BLOCK_H
