// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FITTING_SAME_SIDE_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FITTING_SAME_SIDE_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/Neighborhood_3.h>

#include <boost/container/small_vector.hpp>

#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// A neighborhood without the neighbors on the opposite side: as if these had no weight, but the loops
/// over neighbors need not know of sides.
class Same_side {
  boost::container::small_vector<std::uint32_t, 128> m_neighbors;
  Neighborhood_3 m_neighborhood;

public:
  /// \pre `all.is_sided()`
  explicit Same_side(const Neighborhood_3& all) : m_neighborhood(all)
  {
    for (std::size_t j = 0; j < all.size(); ++j)
      if (!all.is_opposite(j))
        m_neighbors.push_back(all.numbers()[j]);
    m_neighborhood = all.with_neighbors(m_neighbors.data(), m_neighbors.size());
  }
  Same_side(const Same_side&) = delete; // the neighborhood is a view on the neighbors
  Same_side& operator=(const Same_side&) = delete;

  /// is not sided anymore
  const Neighborhood_3& neighborhood() const { return m_neighborhood; }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FITTING_SAME_SIDE_H
