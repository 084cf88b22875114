// SPDX-License-Identifier: GPL-3.0-or-later
#include "Epick_points.h"

#include <CGAL/Scale_space_reconstruction_3/Balanced_flow_smoother.h>
#include <CGAL/Scale_space_reconstruction_3/Jet_smoother.h>
#include <CGAL/Scale_space_surface_reconstruction_3.h>

namespace comparison {

namespace scale = CGAL::Scale_space_reconstruction_3;

Reconstructed scale_space(const Points& points, Scale_smoother smoother)
{
  Epick_points epick = to_epick(points);
  CGAL::Scale_space_surface_reconstruction_3<Epick> reconstruction(epick.begin(), epick.end());
  scale::Weighted_PCA_smoother<Epick> pca;
  pca(epick.begin(), epick.end()); // it tells the radius after it has smoothed
  if (smoother == Scale_smoother::weighted_pca)
    reconstruction.increase_scale(4, pca);
  else if (smoother == Scale_smoother::jet)
    reconstruction.increase_scale<scale::Jet_smoother<Epick>>(4);
  else if (smoother == Scale_smoother::point_set_flow)
    reconstruction.increase_scale<scale::Balanced_flow_smoother<Epick>>();

  reconstruction.reconstruct_surface(
      scale::Alpha_shape_mesher<Epick>(pca.squared_radius(), false, true));
  const Triangles triangles(reconstruction.facets_begin(), reconstruction.facets_end());
  return mesh_of(Epick_points(reconstruction.points_begin(), reconstruction.points_end()),
                 triangles);
}

} // namespace comparison
