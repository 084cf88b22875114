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
  /// of points that have a neighbor too far away, one after the other: how many neighbors, and their numbers
  std::vector<std::uint32_t> m_absolute;
  /// where the neighbors of each point begin, and at the end how many there are. Twice the place in `m_relative`, and
  /// 1 for points whose place in `m_absolute` is there, in two halves.
  std::vector<std::uint32_t> m_begins;

public:
  /// \param points how many will be added, or more
  /// \param neighbors how many they have, or more
  void reserve(std::size_t points, std::size_t neighbors)
  {
    m_begins.reserve(points + 1);
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
    bool is_near = true;
    for (std::size_t j = 0; j < size; ++j) {
      const std::int64_t difference = std::int64_t(number(j)) - std::int64_t(site);
      m_relative[begin + j] = static_cast<std::int16_t>(difference);
      is_near &= m_relative[begin + j] == difference;
    }
    if (!is_near) {
      m_relative.resize(begin);
      const std::size_t place = m_absolute.size();
      m_relative.push_back(static_cast<std::int16_t>(place & 0xffff));
      m_relative.push_back(static_cast<std::int16_t>(place >> 16));
      m_absolute.push_back(static_cast<std::uint32_t>(size));
      for (std::size_t j = 0; j < size; ++j)
        m_absolute.push_back(number(j));
    }
    m_begins.push_back(static_cast<std::uint32_t>(2 * begin + (is_near ? 0 : 1)));
  }

  /// To be called after the last point.
  /// \param n the number of points in the chunk
  void finish(std::size_t n) { skip(n + 1); }

  /// \param i the place of the point in the chunk
  /// \param site the number of the point
  Neighbor_numbers neighbors(std::size_t i, std::size_t site) const
  {
    const std::int16_t* const begin = m_relative.data() + m_begins[i] / 2;
    if (m_begins[i] % 2 == 0)
      return Neighbor_numbers(site, begin, m_begins[i + 1] / 2 - m_begins[i] / 2);
    const std::uint32_t place =
        std::uint32_t(std::uint16_t(begin[0])) | std::uint32_t(std::uint16_t(begin[1])) << 16;
    return Neighbor_numbers(m_absolute.data() + place + 1, m_absolute[place]);
  }

private:
  /// Points up to the `i`-th that were not added have no neighbors.
  void skip(std::size_t i) { m_begins.resize(i, static_cast<std::uint32_t>(2 * m_relative.size())); }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_NEIGHBOR_CHUNK_H
