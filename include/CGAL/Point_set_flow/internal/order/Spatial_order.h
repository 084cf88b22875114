// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_ORDER_SPATIAL_ORDER_H
#define CGAL_POINT_SET_FLOW_INTERNAL_ORDER_SPATIAL_ORDER_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/Core_kernel.h>
#include <CGAL/Point_set_flow/internal/parallel/Array.h>
#include <CGAL/Point_set_flow/internal/parallel/Loops.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// Numbers points along a space-filling curve, so that neighbors in space are mostly neighbors in
/// memory. The order depends on the positions of the points only, not on that of the input, and
/// makes duplicates adjacent.
///
/// The curve is that of Morton through a grid of the bounding box. Points that share a cell, which
/// are many if there are clusters or a point far away, are ordered likewise in their own bounding box.
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

public:
  /// \param from distinguishes points at the same place; empty if nothing does
  Spatial_order(const Array<Point_3>& points, const Array<Point_3>& from,
                Loops<ConcurrencyTag>& loops)
      : m_points(points), m_from(from), m_loops(loops), m_order(points.size())
  {
    for (std::size_t i = 0; i < points.size(); ++i)
      m_order[i].index = static_cast<std::uint32_t>(i);
    sort(m_order.begin(), m_order.end());
  }

  std::size_t size() const { return m_order.size(); }
  std::uint32_t operator[](std::size_t i) const { return m_order[i].index; }

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
    const double extent = (std::max)({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
    const std::size_t small = 16;
    if (std::size_t(last - first) <= small || !(extent > 0.)) {
      std::sort(first, last, [&](const Keyed_index& a, const Keyed_index& b) {
        return coordinates(a.index) < coordinates(b.index);
      });
      return;
    }

    const double last_cell = (1 << 21) - 1;
    const auto find_keys = [&](std::size_t begin, std::size_t end) {
      for (Iterator it = first + std::ptrdiff_t(begin); it != first + std::ptrdiff_t(end); ++it) {
        const Point_3& p = m_points[it->index];
        it->key = 0;
        for (std::size_t d = 0; d < 3; ++d)
          it->key |= spread(std::uint64_t((p[int(d)] - low[d]) / extent * last_cell)) << d;
      }
    };
    m_loops.for_each_chunk(std::size_t(last - first), find_keys);
    m_loops.sort(first, last);

    // the first and the last point are in different cells: the recursion terminates
    for (Iterator begin = first; begin != last;) {
      const Iterator end = std::find_if(
          begin, last, [&](const Keyed_index& point) { return point.key != begin->key; });
      if (end - begin > 1)
        sort(begin, end);
      begin = end;
    }
  }

  /// Moves the lowest 21 bits three places apart.
  static std::uint64_t spread(std::uint64_t x)
  {
    x = (x | x << 32) & 0x001f00000000ffff;
    x = (x | x << 16) & 0x001f0000ff0000ff;
    x = (x | x << 8) & 0x100f00f00f00f00f;
    x = (x | x << 4) & 0x10c30c30c30c30c3;
    return (x | x << 2) & 0x1249249249249249;
  }

  std::tuple<Point_3, Point_3> coordinates(std::uint32_t i) const
  {
    return {m_points[i], m_from.empty() ? m_points[i] : m_from[i]};
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_ORDER_SPATIAL_ORDER_H
