// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_BENCHMARK_SCANS_H
#define POINT_SET_FLOW_BENCHMARK_SCANS_H

#include "Mesh_measures.h"
#include "Pipelines.h"

#include "Benchmark_shapes.h"
#include "measure/Noise_models.h"
#include "measure/sample_mesh.h"

#include <CGAL/IO/read_points.h>
#include <CGAL/remove_outliers.h>

#include <random>
#include <stdexcept>

namespace comparison {

/// Points of a scanned surface and what is known of it
struct Scan {
  std::string name;
  Points points;
  Truth truth;
  std::optional<Topology> topology; ///< of the truth

  /// Normals of the true surface, as a scanner knows on which side it was; none if there is no truth
  Vectors sides() const
  {
    Vectors result;
    if (truth.surface)
      for (const Point_3& p : points)
        result.push_back(truth.surface->closest(p).normal);
    return result;
  }
};

inline Points read_scan(const std::string& name)
{
  Points points;
  if (!CGAL::IO::read_points(CGAL::data_file_path("points_3/" + name), std::back_inserter(points)))
    throw std::runtime_error("cannot read " + name);
  return points;
}

inline Points without_outliers(Points points, double percent)
{
  points.erase(CGAL::remove_outliers<CGAL::Parallel_if_available_tag>(
                   points, 24, CGAL::parameters::threshold_percent(percent)),
               points.end());
  return points;
}

/// Samples of a mesh with noise: the mesh is the truth
inline Scan sampled(const std::string& name, const std::string& shape, const std::string& condition,
                    double noise, std::size_t n)
{
  std::shared_ptr<const Mesh_surface> surface = load_shape(shape, n);
  if (!surface)
    throw std::runtime_error("cannot read " + shape);
  const Points clean = sample_mesh(*surface, n, 1).points;
  return {name,
          add_noise(clean, condition, noise, 11).points,
          {surface, clean},
          topology_of(surface->mesh())};
}

/// A scan that is known to be clean, with noise: the surface through its points is the truth
inline Scan with_noise_added(const std::string& name, const std::string& file, double noise)
{
  Points clean = read_scan(file);
  Unit_sphere_map::of(clean).apply(clean);
  Reconstructed mesh = advancing_front(clean);
  if (!mesh)
    throw std::runtime_error("no surface through " + file);
  const Topology topology = topology_of(*mesh);
  return {name,
          add_noise(clean, "Gaussian", noise, 11).points,
          {std::make_shared<Mesh_surface>(std::move(*mesh)), clean},
          topology};
}

/// A scan as it is: each tenth point is held back, and lies on the true surface but for its noise
inline Scan as_scanned(const std::string& name, const std::string& file)
{
  Points points = read_scan(file);
  Unit_sphere_map::of(points).apply(points);
  std::mt19937 random(1);
  Scan scan{name, {}, {}, {}};
  for (const Point_3& p : points)
    (random() % 10 == 0 ? scan.truth.points : scan.points).push_back(p);
  return scan;
}

} // namespace comparison

#endif // POINT_SET_FLOW_BENCHMARK_SCANS_H
