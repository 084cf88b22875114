// SPDX-License-Identifier: GPL-3.0-or-later
#include "Epick_points.h"

#include <CGAL/Advancing_front_surface_reconstruction.h>

namespace comparison {

Reconstructed advancing_front(const Points& points)
{
  const Epick_points epick = to_epick(points);
  Triangles triangles;
  CGAL::advancing_front_surface_reconstruction(epick.begin(), epick.end(),
                                               std::back_inserter(triangles));
  return mesh_of(epick, triangles);
}

} // namespace comparison
