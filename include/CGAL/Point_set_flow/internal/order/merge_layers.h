// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_ORDER_MERGE_LAYERS_H
#define CGAL_POINT_SET_FLOW_INTERNAL_ORDER_MERGE_LAYERS_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/Core_kernel.h>
#include <CGAL/Point_set_flow/internal/parallel/Array.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// Compares vectors regardless of their orientation: the least of several is the same if all of them
/// are turned over.
inline bool less_up_to_sign(const Vector_3& a, const Vector_3& b)
{
  const auto turned = [](const Vector_3& v) {
    const double first = v.x() != 0. ? v.x() : v.y() != 0. ? v.y() : v.z();
    const double sign = first < 0. ? -1. : 1.;
    return std::make_tuple(sign * v.x(), sign * v.y(), sign * v.z());
  };
  return turned(a) < turned(b);
}

/// The given side of each site. That of duplicates is one of theirs, which does not depend on their
/// order; null if they disagree.
/// \param given a unit vector for each point, or null where the side is not known
/// \param site_of for each point, its site
/// \param n the number of sites
inline Array<Vector_3> merged_sides(const Array<Vector_3>& given,
                                    const std::vector<std::uint32_t>& site_of, std::size_t n)
{
  if (given.empty())
    return {};
  Array<Vector_3> sides(n, Vector_3(0., 0., 0.));
  for (std::size_t i = 0; i < given.size(); ++i) {
    Vector_3& side = sides[site_of[i]];
    if (given[i] != NULL_VECTOR && (side == NULL_VECTOR || less_up_to_sign(given[i], side)))
      side = given[i];
  }
  std::vector<std::uint32_t> in_doubt;
  for (std::size_t i = 0; i < given.size(); ++i)
    if (given[i] * sides[site_of[i]] < 0.)
      in_doubt.push_back(site_of[i]);
  for (const std::uint32_t site : in_doubt)
    sides[site] = NULL_VECTOR;
  return sides;
}

/// The number of the scan of each site, of duplicates the least.
inline Array<std::uint32_t> merged_scans(const Array<std::uint32_t>& given,
                                         const std::vector<std::uint32_t>& site_of, std::size_t n)
{
  if (given.empty())
    return {};
  Array<std::uint32_t> scans(n, (std::numeric_limits<std::uint32_t>::max)());
  for (std::size_t i = 0; i < given.size(); ++i)
    scans[site_of[i]] = (std::min)(scans[site_of[i]], given[i]);
  return scans;
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_ORDER_MERGE_LAYERS_H
