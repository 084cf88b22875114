// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_BENCHMARK_PUNET_CASE_H
#define POINT_SET_FLOW_BENCHMARK_PUNET_CASE_H

#include "face_distances.h"

#include "Peers.h"
#include "pairs/run_pairs.h"

namespace comparison {

/// The measures of the learned denoisers, x 1e4: the two-way Chamfer distance on the unit sphere of
/// the clean cloud, and the two-way distance of points and faces on that of the mesh.
struct Punet_score {
  double cd = std::numeric_limits<double>::infinity(), p2m = cd;
  std::string setting;
};

/// A noisy cloud of PU-Net's test set, its clean one and its mesh
struct Punet_case {
  std::string shape;
  std::size_t n;
  std::string noise; ///< of the radius, as the files have it
  Points noisy, clean;
  std::shared_ptr<const Mesh_surface> surface;
  Unit_sphere_map cloud_sphere, mesh_sphere;

  Punet_score score(const Points& points, const std::string& setting) const
  {
    Points on_cloud = points, on_mesh = points;
    cloud_sphere.apply(on_cloud);
    mesh_sphere.apply(on_mesh);
    Test_cloud to_mesh;
    to_mesh.surface = surface;
    const double rms = to_mesh.error_of(on_mesh);
    return {1e4 * chamfer_distance(on_cloud, clean),
            1e4 * (rms * rms + mean_squared_face_distance(*surface, on_mesh)), setting};
  }
};

/// Calls `visit` with each case for which there are files.
template <typename Visit>
void for_each_punet_case(const std::filesystem::path& folder,
                         const std::vector<std::size_t>& numbers_of_points, const Visit& visit)
{
  const std::string ending = "_mesh.off";
  std::vector<std::string> shapes;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.size() > ending.size() &&
        name.compare(name.size() - ending.size(), ending.size(), ending) == 0)
      shapes.push_back(name.substr(0, name.size() - ending.size()));
  }
  std::sort(shapes.begin(), shapes.end());
  for (const std::size_t n : numbers_of_points)
    for (const char* noise : {"0.01", "0.02", "0.03"})
      for (const std::string& shape : shapes) {
        const std::string stem = shape + "_" + std::to_string(n);
        const auto noisy_file = folder / (stem + "_noisy_" + noise + ".ply");
        if (!std::filesystem::exists(noisy_file))
          continue;
        Punet_case found{
            shape,   n,  noise, read_cloud(noisy_file), read_cloud(folder / (stem + "_clean.ply")),
            nullptr, {}, {}};
        std::optional<Mesh> mesh =
            read_mesh((folder / (shape + ending)).string(), found.mesh_sphere);
        if (!mesh)
          throw std::runtime_error("cannot read the mesh of " + shape);
        found.surface = std::make_shared<Mesh_surface>(std::move(*mesh));
        found.cloud_sphere = Unit_sphere_map::of(found.clean);
        found.cloud_sphere.apply(found.clean);
        visit(found);
      }
}

} // namespace comparison

#endif // POINT_SET_FLOW_BENCHMARK_PUNET_CASE_H
