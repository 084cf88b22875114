// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef COMPARISON_MEASURE_H
#define COMPARISON_MEASURE_H

#include "Result_table.h"
#include "Smoothers.h"
#include "Smoothing_measures.h"

#include <memory>

namespace comparison {

/// Noisy points in the unit sphere, and what is known of the truth.
struct Noisy_data {
  Points noisy;
  Samples clean;                    ///< point i without noise; empty if not known
  std::unique_ptr<Surface> surface; ///< null if not known
  double edge_distance = 0.;        ///< what is nearer to a sharp edge counts as near
};

/// Row of the table for smoothed points. Lengths in thousandths of the radius; squared distances x
/// 1e4, as the learned denoisers give them. `signed_distances` is filled if the surface is known.
inline Result_table::Named_numbers measure(const Noisy_data& data, const Smoothed& smoothed,
                                           double seconds, double megabytes,
                                           std::vector<double>& signed_distances)
{
  double rms = unknown, max = unknown, edge_rms = unknown, edge_max = unknown, mean = unknown;
  double p2m = unknown, chamfer = unknown, drift = unknown, moved = unknown, angle = unknown;
  if (data.surface) {
    const Surface_errors errors(smoothed.points, *data.surface,
                                smoothed.same_points ? data.clean.near_edge : std::vector<char>(),
                                data.edge_distance);
    rms = 1e3 * errors.all.rms();
    max = 1e3 * errors.all.max();
    edge_rms = 1e3 * errors.near_edges.rms();
    edge_max = 1e3 * errors.near_edges.max();
    mean = 1e3 * errors.all.mean();
    p2m = 1e4 * errors.all.mean_square();
    chamfer = 1e4 * chamfer_distance(smoothed.points, data.clean.points);
    angle = normal_error(smoothed.normals.empty() ? pca_normals(smoothed.points) : smoothed.normals,
                         errors.true_normals);
    signed_distances = errors.signed_distances;
    if (smoothed.same_points)
      drift = 1e3 * tangential_drift(data.noisy, smoothed.points, data.clean.normals);
  }
  if (smoothed.same_points)
    moved = 1e3 * movement(data.noisy, smoothed.points);
  const Spacing nearest = spacing(smoothed.points);
  return {{"rms", rms},
          {"max", max},
          {"edge rms", edge_rms},
          {"edge max", edge_max},
          {"signed mean", mean},
          {"CD x1e4", chamfer},
          {"P2M x1e4", p2m},
          {"drift", drift},
          {"movement", moved},
          {"spacing", 1e3 * nearest.mean},
          {"spacing CV", nearest.variation},
          {"roughness", 1e3 * roughness(smoothed.points)},
          {"normal deg", angle},
          {"seconds", seconds},
          {"MB", megabytes}};
}

} // namespace comparison

#endif // COMPARISON_MEASURE_H
