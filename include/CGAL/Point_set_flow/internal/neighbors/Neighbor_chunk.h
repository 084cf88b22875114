// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_NEIGHBOR_CHUNK_H
#define CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_NEIGHBOR_CHUNK_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/Neighborhood_3.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// The neighbors of a chunk of points. Most are near in the order of the points, too: their numbers take two
/// bytes each, relative to that of the point.
class Neighbor_chunk {
  std::vector<std::int16_t> m_relative;
  std::vector<std::uint32_t> m_absolute; // of points that have a neighbor too far away

public:
  /// Where the neighbors of a point are
  struct Place {
    std::uint32_t begin;
    std::uint32_t size : 31, is_relative : 1;
  };

  /// Adds the neighbors of a point.
  /// \param site the number of the point
  /// \param number tells the number of neighbor `j` of `size`
  template <typename Number>
  Place add(std::size_t site, std::size_t size, const Number& number)
  {
    const std::size_t begin = m_relative.size();
    m_relative.resize(begin + size);
    bool is_near = true;
    for (std::size_t j = 0; j < size; ++j) {
      const std::int64_t difference = std::int64_t(number(j)) - std::int64_t(site);
      m_relative[begin + j] = static_cast<std::int16_t>(difference);
      is_near &= m_relative[begin + j] == difference;
    }
    if (is_near)
      return {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(size) & 0x7fffffff, 1};
    m_relative.resize(begin);
    for (std::size_t j = 0; j < size; ++j)
      m_absolute.push_back(number(j));
    return {static_cast<std::uint32_t>(m_absolute.size() - size),
            static_cast<std::uint32_t>(size) & 0x7fffffff, 0};
  }

  Neighbor_numbers neighbors(std::size_t site, Place place) const
  {
    return place.is_relative ? Neighbor_numbers(site, m_relative.data() + place.begin, place.size)
                             : Neighbor_numbers(m_absolute.data() + place.begin, place.size);
  }

  /// Frees memory that is not used.
  void fit()
  {
    m_relative.shrink_to_fit();
    m_absolute.shrink_to_fit();
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_NEIGHBOR_CHUNK_H
