// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_BENCHMARK_RUN_PAIRS_H
#define POINT_SET_FLOW_BENCHMARK_RUN_PAIRS_H

#include "Fitted_surface.h"

#include "measure/read_mesh.h"
#include "field/Comparison.h"

#include <CGAL/IO/read_points.h>

#include <filesystem>
#include <stdexcept>

namespace comparison {

inline Points read_cloud(const std::filesystem::path& file)
{
  Points points;
  if (!CGAL::IO::read_points(file.string(), std::back_inserter(points)) || points.empty())
    throw std::runtime_error("cannot read " + file.string());
  return points;
}

/// The names X of files X_clean.ply for which there is X_noisy.ply, too
inline std::vector<std::string> names_of_pairs(const std::filesystem::path& folder)
{
  const std::string ending = "_clean.ply";
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.size() <= ending.size() ||
        name.compare(name.size() - ending.size(), ending.size(), ending) != 0)
      continue;
    const std::string x = name.substr(0, name.size() - ending.size());
    if (std::filesystem::exists(folder / (x + "_noisy.ply")))
      names.push_back(x);
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// A real scan and the surface that a better one, or a model, says it has; scaled to its unit sphere
inline Test_cloud read_pair(const std::filesystem::path& folder, const std::string& name)
{
  Test_cloud pair;
  pair.name = name;
  pair.points = read_cloud(folder / (name + "_noisy.ply"));
  const std::filesystem::path reference = folder / (name + "_clean.ply");
  Unit_sphere_map to_unit_sphere;
  std::optional<Mesh> mesh = read_mesh(reference.string(), to_unit_sphere);
  if (mesh)
    pair.surface = std::make_shared<Mesh_surface>(std::move(*mesh));
  else {
    Points points = read_cloud(reference);
    to_unit_sphere = Unit_sphere_map::of(points);
    to_unit_sphere.apply(points);
    pair.surface = std::make_shared<Fitted_surface>(points);
  }
  to_unit_sphere.apply(pair.points);
  pair.spacing = typical_spacing(pair.points);
  return pair;
}

/// The error is one-way: from the smoothed points to the surface, of which a scan may show a part.
inline void run_pairs(const std::string& folder, Targets& targets)
{
  Comparison_table table("Real scans");
  for (const std::string& name : names_of_pairs(folder)) {
    const Test_cloud pair = read_pair(folder, name);
    table.add(pair, Comparison(pair, Rivals::jets_and_bilateral));
  }
  const std::string what = "error to the best of nothing, jets and bilateral, real scans";
  targets.mean_at_most(.96, 4, what, table.ratios());
  targets.all_at_most(1.02, 4, what, table.ratios());
}

} // namespace comparison

#endif // POINT_SET_FLOW_BENCHMARK_RUN_PAIRS_H
