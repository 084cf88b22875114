// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_ORDER_SPATIAL_ORDER_H
#define CGAL_POINT_SET_FLOW_INTERNAL_ORDER_SPATIAL_ORDER_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/Core_kernel.h>
#include <CGAL/Point_set_flow/internal/order/Morton_curve.h>
#include <CGAL/Point_set_flow/internal/parallel/Array.h>
#include <CGAL/Point_set_flow/internal/parallel/Loops.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// Numbers points along a Morton curve, so that neighbors in space are mostly neighbors in memory. Which
/// of two points comes first depends on these two only: some of the points have the same order as among
/// all. Duplicates are adjacent.
///
/// Points that share a cell of the grid, which are many if there are clusters or a point far away, are
/// sorted once more, in a finer grid.
template <typename ConcurrencyTag>
class Spatial_order {
  struct Keyed_index {
    std::uint64_t key; // the number of the cell
    std::uint32_t index;
    bool operator<(const Keyed_index& other) const { return key < other.key; }
  };
  typedef typename Array<Keyed_index>::iterator Iterator;

  const Array<Point_3>& m_points;
  const Array<Point_3>& m_from;
  Loops<ConcurrencyTag>& m_loops;
  Array<Keyed_index> m_order;
  Array<std::uint32_t> m_indices; // in the order

public:
  /// \param from distinguishes points at the same place; empty if nothing does
  Spatial_order(const Array<Point_3>& points, const Array<Point_3>& from,
                Loops<ConcurrencyTag>& loops)
      : m_points(points), m_from(from), m_loops(loops), m_order(points.size())
  {
    for (std::size_t i = 0; i < points.size(); ++i)
      m_order[i].index = static_cast<std::uint32_t>(i);
    sort(m_order.begin(), m_order.end());
    m_indices.resize(m_order.size());
    for (std::size_t i = 0; i < m_order.size(); ++i)
      m_indices[i] = m_order[i].index;
    m_order = Array<Keyed_index>(); // memory
  }

  std::size_t size() const { return m_indices.size(); }
  std::uint32_t operator[](std::size_t i) const { return m_indices[i]; }

private:
  void sort(Iterator first, Iterator last)
  {
    std::array<double, 3> low, high;
    for (std::size_t d = 0; d < 3; ++d) {
      low[d] = high[d] = m_points[first->index][int(d)];
      for (Iterator it = first; it != last; ++it) {
        const double c = m_points[it->index][int(d)];
        low[d] = (std::min)(low[d], c);
        high[d] = (std::max)(high[d], c);
      }
    }
    const std::size_t small = 16;
    if (std::size_t(last - first) <= small || low == high) {
      std::sort(first, last, [&](const Keyed_index& a, const Keyed_index& b) {
        return is_before(a.index, b.index);
      });
      return;
    }

    const Morton_cells cells(low, high);
    const auto find_keys = [&](std::size_t begin, std::size_t end) {
      for (Iterator it = first + std::ptrdiff_t(begin); it != first + std::ptrdiff_t(end); ++it)
        it->key = cells.number(m_points[it->index]);
    };
    m_loops.for_each_chunk(std::size_t(last - first), find_keys);
    m_loops.sort(first, last);

    // not all points are in one cell: the recursion terminates
    for (Iterator begin = first; begin != last;) {
      const Iterator end = std::find_if(
          begin, last, [&](const Keyed_index& point) { return point.key != begin->key; });
      if (end - begin > 1)
        sort(begin, end);
      begin = end;
    }
  }

  bool is_before(std::uint32_t i, std::uint32_t j) const
  {
    if (m_from.empty() || m_points[i] != m_points[j])
      return is_before_on_morton_curve(m_points[i], m_points[j]);
    return m_from[i] < m_from[j];
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_ORDER_SPATIAL_ORDER_H
