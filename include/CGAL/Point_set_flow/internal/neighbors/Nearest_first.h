// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_NEAREST_FIRST_H
#define CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_NEAREST_FIRST_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/neighbors/Neighbor.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// Sorts the nearest of some points by distance. The number of points in a ball on a surface grows with its
/// squared radius, so that as many intervals of squared distances as there are points hold about one each:
/// what is left to sort is little.
class Nearest_first {
  std::vector<std::uint32_t> m_intervals; // of each point
  std::vector<std::uint32_t> m_ends;      // of the points in each interval

public:
  /// \param points, size in the order of the points; are reordered
  /// \param wanted how many
  /// \param squared_limit no point is farther; may be infinite
  /// \param nearest receives the nearest `wanted`, or all if there are fewer
  void operator()(Neighbor* points, std::size_t size, std::size_t wanted, double squared_limit,
                  std::vector<Neighbor>& nearest)
  {
    wanted = (std::min)(wanted, size);
    const double scale = double(size) / squared_limit;
    const std::size_t too_many = 256; // to sort by insertion
    if (wanted > too_many || !(scale > 0.) || !(scale * squared_limit < double(size) + 1.)) {
      sort(points, size, wanted, nearest);
      return;
    }
    m_intervals.resize((std::max)(m_intervals.size(), size));
    m_ends.assign(size + 2, 0);
    for (std::size_t i = 0; i < size; ++i) {
      const auto interval = static_cast<std::uint32_t>(int(points[i].squared_distance * scale));
      m_intervals[i] = interval;
      ++m_ends[interval + 1];
    }
    std::size_t last = 0; // interval that counts
    while (m_ends[last + 1] < wanted) {
      m_ends[last + 2] += m_ends[last + 1];
      ++last;
    }
    const std::size_t kept = m_ends[last + 1];
    if (kept > 2 * wanted) {
      sort(points, size, wanted, nearest);
      return;
    }
    nearest.resize(kept + 1); // and one for those that do not count
    for (std::size_t i = 0; i < size; ++i) {
      const bool counts = m_intervals[i] <= last;
      nearest[counts ? m_ends[m_intervals[i]]++ : kept] = points[i];
    }
    nearest.pop_back();
    for (std::size_t i = 1; i < kept; ++i) {
      const Neighbor moving = nearest[i];
      std::size_t place = i;
      for (; place > 0 && moving < nearest[place - 1]; --place)
        nearest[place] = nearest[place - 1];
      nearest[place] = moving;
    }
    nearest.resize(wanted);
  }

private:
  static void sort(Neighbor* points, std::size_t size, std::size_t wanted,
                   std::vector<Neighbor>& nearest)
  {
    std::nth_element(points, points + (wanted == 0 ? 0 : wanted - 1), points + size);
    nearest.assign(points, points + wanted);
    std::sort(nearest.begin(), nearest.end());
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_NEAREST_FIRST_H
