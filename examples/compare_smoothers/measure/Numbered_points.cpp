// SPDX-License-Identifier: GPL-3.0-or-later
#include "Numbered_points.h"

#include <CGAL/mst_orient_normals.h>
#include <CGAL/pca_estimate_normals.h>

namespace comparison {

template <typename ConcurrencyTag>
Numbered_points with_normals(const Points& points, bool orient, unsigned int k)
{
  Numbered_points result;
  for (const Point_3& p : points)
    result.emplace_back(p, CGAL::NULL_VECTOR, result.size());
  CGAL::pca_estimate_normals<ConcurrencyTag>(result, k, numbered_point_maps());
  if (orient)
    CGAL::mst_orient_normals(result, k, numbered_point_maps());
  return result;
}

template Numbered_points with_normals<CGAL::Sequential_tag>(const Points&, bool, unsigned int);
#ifdef CGAL_LINKED_WITH_TBB
template Numbered_points with_normals<CGAL::Parallel_tag>(const Points&, bool, unsigned int);
#endif

} // namespace comparison
