// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_CLEARANCE_H
#define CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_CLEARANCE_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/parallel/Array.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// How far around each site all points of a point set are at hand, of which some may be missing. A
/// search is certain if its ball ends before that.
class Clearance {
  Array<double> m_distances; // to where points may be missing; empty if none are

public:
  /// Of a whole point set
  Clearance() = default;

  /// \param given for each point; empty if none are missing
  /// \param site_of for each point, its site
  /// \param n the number of sites
  Clearance(const Array<double>& given, const std::vector<std::uint32_t>& site_of, std::size_t n)
      : m_distances(given.empty() ? 0 : n, (std::numeric_limits<double>::infinity)())
  {
    for (std::size_t i = 0; i < given.size(); ++i)
      m_distances[site_of[i]] = (std::min)(m_distances[site_of[i]], given[i]);
  }

  bool is_whole() const { return m_distances.empty(); }

  /// Whether all points within a radius around a site are at hand.
  bool holds(std::size_t site, double radius) const
  {
    const double infinity = (std::numeric_limits<double>::infinity)();
    return is_whole() || radius < m_distances[site] || m_distances[site] == infinity;
  }

  /// \pre the point set is not whole
  double distance(std::size_t site) const { return m_distances[site]; }
};

/// The radius within which points decide a search for the nearest `k`: infinite if there are fewer.
/// \param farthest the distance of the farthest of those found
/// \param limit beyond which no points are searched, 0 for none
inline double searched_radius(std::size_t found, std::size_t k, double farthest, double limit = 0.)
{
  return found >= k ? farthest : limit > 0. ? limit : (std::numeric_limits<double>::infinity)();
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_CLEARANCE_H
