// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_EXIT_NEW_NORMALS_H
#define CGAL_POINT_SET_FLOW_INTERNAL_EXIT_NEW_NORMALS_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/Core_kernel.h>
#include <CGAL/Point_set_flow/internal/parallel/Array.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// The normal oriented as the given one. A point without a plane of neighbors keeps that one.
inline Vector_3 oriented_normal(const Vector_3& normal, const Vector_3& given)
{
  const double length = std::sqrt(given.squared_length());
  if (normal == NULL_VECTOR)
    return length > 0. && std::isfinite(length) ? given / length : Vector_3(0., 0., 1.);
  return normal * given < 0. ? -normal : normal;
}

/// The normals that are to be written, in the order of the caller; none if there is no normal map.
/// \param site_of for each point, where it is in `normals`
template <typename Maps>
std::vector<typename Maps::Kernel_vector_3> new_normals(const Maps& maps,
                                                        const Array<Vector_3>& normals,
                                                        const std::vector<std::uint32_t>& site_of)
{
  typedef typename Maps::FT FT;
  typedef typename Maps::Kernel_vector_3 Kernel_vector_3;
  std::vector<Kernel_vector_3> oriented;
  if (!maps.normal_map)
    return oriented;
  std::size_t i = 0;
  for (auto it = maps.points.begin(); it != maps.points.end(); ++it, ++i) {
    const Kernel_vector_3& given = get(*maps.normal_map, *it);
    const Vector_3 n =
        oriented_normal(normals[site_of[i]],
                        Vector_3(to_double(given.x()), to_double(given.y()), to_double(given.z())));
    oriented.push_back(Kernel_vector_3(FT(n.x()), FT(n.y()), FT(n.z())));
  }
  return oriented;
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_EXIT_NEW_NORMALS_H
