// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_NEIGHBOR_CHUNK_H
#define CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_NEIGHBOR_CHUNK_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/Neighborhood_3.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// The neighbors of a chunk of points. Most are near in the order of the points, too: their numbers take two
/// bytes each, relative to that of the point.
class Neighbor_chunk {
  static constexpr std::uint16_t is_absolute = (std::numeric_limits<std::uint16_t>::max)();

  std::vector<std::int16_t> m_relative;
  /// of points that have a neighbor too far away, one after the other: how many neighbors, and their numbers
  std::vector<std::uint32_t> m_absolute;
  std::vector<std::uint32_t> m_begins; // of each point, in one of the two
  std::vector<std::uint16_t> m_sizes;

public:
  /// \param points how many will be added, or more
  /// \param neighbors how many they have, or more
  void reserve(std::size_t points, std::size_t neighbors)
  {
    m_begins.reserve(points);
    m_sizes.reserve(points);
    m_relative.reserve(neighbors);
  }

  /// Adds the neighbors of a point.
  /// \param i the place of the point in the chunk, beyond that of those before
  /// \param site the number of the point
  /// \param number tells the number of neighbor `j` of `size`
  template <typename Number>
  void add(std::size_t i, std::size_t site, std::size_t size, const Number& number)
  {
    skip(i);
    const std::size_t begin = m_relative.size();
    m_relative.resize(begin + size);
    bool is_near = size < is_absolute;
    for (std::size_t j = 0; j < size; ++j) {
      const std::int64_t difference = std::int64_t(number(j)) - std::int64_t(site);
      m_relative[begin + j] = static_cast<std::int16_t>(difference);
      is_near &= m_relative[begin + j] == difference;
    }
    if (is_near) {
      m_begins.push_back(static_cast<std::uint32_t>(begin));
      m_sizes.push_back(static_cast<std::uint16_t>(size));
      return;
    }
    m_relative.resize(begin);
    m_begins.push_back(static_cast<std::uint32_t>(m_absolute.size()));
    m_sizes.push_back(is_absolute);
    m_absolute.push_back(static_cast<std::uint32_t>(size));
    for (std::size_t j = 0; j < size; ++j)
      m_absolute.push_back(number(j));
  }

  /// Points up to the `i`-th that were not added have no neighbors.
  void skip(std::size_t i)
  {
    m_begins.resize(i, 0);
    m_sizes.resize(i, 0);
  }

  /// Leaves a point the first of its neighbors. Their memory is not freed: it would be in many small pieces.
  /// \pre it has not fewer
  void shrink(std::size_t i, std::size_t size)
  {
    if (m_sizes[i] == is_absolute)
      m_absolute[m_begins[i]] = static_cast<std::uint32_t>(size);
    else
      m_sizes[i] = static_cast<std::uint16_t>(size);
  }

  /// \param i the place of the point in the chunk
  /// \param site the number of the point
  Neighbor_numbers neighbors(std::size_t i, std::size_t site) const
  {
    if (m_sizes[i] != is_absolute)
      return Neighbor_numbers(site, m_relative.data() + m_begins[i], m_sizes[i]);
    const std::uint32_t* const absolute = m_absolute.data() + m_begins[i];
    return Neighbor_numbers(absolute + 1, *absolute);
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_NEIGHBOR_CHUNK_H
