// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_BENCHMARK_PUNET_CASE_H
#define POINT_SET_FLOW_BENCHMARK_PUNET_CASE_H

#include "face_distances.h"
#include "published_scores.h"

#include "Peers.h"
#include "pairs/run_pairs.h"

namespace comparison {

/// The measures of the learned denoisers, x 1e4: the two-way Chamfer distance on the unit sphere of
/// the clean cloud, and the two-way distance of points and faces on that of the mesh. And ours.
struct Punet_score {
  double cd, p2m;
  double rms;       ///< distance from the points to the mesh, x 1e3
  double variation; ///< of the spacing, see `Spacing`
  double gap;       ///< the largest distance from a clean point to the nearest one, in spacings
  std::string setting;
};

/// A noisy cloud of PU-Net's test set, its clean one and its mesh
struct Punet_case {
  std::string shape;
  Punet_group group;
  Points noisy, clean; ///< the clean ones in their unit sphere
  std::shared_ptr<const Mesh_surface> surface;
  Unit_sphere_map cloud_sphere, mesh_sphere;

  std::string name() const { return shape + ", " + group.name(); }
  /// That of the noisy cloud, and of what others have made of it
  std::string file_name() const
  {
    return shape + "_" + std::to_string(group.n) + "_noisy_" + group.noise + ".ply";
  }

  Punet_score score(const Points& points, const std::string& setting) const
  {
    Points on_cloud = points, on_mesh = points;
    cloud_sphere.apply(on_cloud);
    mesh_sphere.apply(on_mesh);
    Test_cloud to_mesh;
    to_mesh.surface = surface;
    const double rms = to_mesh.error_of(on_mesh);
    return {1e4 * chamfer_distance(on_cloud, clean),
            1e4 * (rms * rms + mean_squared_face_distance(*surface, on_mesh)),
            1e3 * rms,
            spacing(on_cloud).variation,
            largest_gap(on_cloud) / spacing(clean).mean,
            setting};
  }

private:
  double largest_gap(const Points& points) const
  {
    const Nearest_points nearest(points);
    double largest = 0.;
    for (const Point_3& p : clean)
      largest = (std::max)(largest, nearest(p).second);
    return std::sqrt(largest);
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
  for (const Punet_group& group : punet_groups())
    if (std::find(numbers_of_points.begin(), numbers_of_points.end(), group.n) !=
        numbers_of_points.end())
      for (const std::string& shape : shapes) {
        Punet_case found;
        found.shape = shape;
        found.group = group;
        if (!std::filesystem::exists(folder / found.file_name()))
          continue;
        found.noisy = read_cloud(folder / found.file_name());
        found.clean = read_cloud(folder / (shape + "_" + std::to_string(group.n) + "_clean.ply"));
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
