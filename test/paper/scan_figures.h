// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_PAPER_SCAN_FIGURES_H
#define POINT_SET_FLOW_PAPER_SCAN_FIGURES_H

#include "Paper_flow.h"
#include "Paper_case.h"
#include "Reconstruction.h"

#include "baselines/bilateral_denoising.h"
#include "baselines/laplacian.h"

#include <CGAL/IO/read_points.h>

namespace comparison {

/// Fig. 9 for one scan: smoothed by the methods that the paper compares, then surfaces of the results
/// \param detail the scan with the relief that counts as the whole
/// \param surface the true one if `detail` has no noise, else null
inline void scan_figure(const Run_settings& s, const std::string& name, const Points& scan,
                        const Points& detail, const Surface* surface)
{
  Figure cloud(s.folder, "fig9_" + name), mesh(s.folder, "fig9_" + name + "_surface");
  Result_table table;
  const Relief relief(detail);
  const double before = spacing(scan).mean;
  const auto add = [&](const std::string& title, const Points& points) {
    const Triangles triangles = reconstruct(points);
    const Surface_quality quality(points, triangles);
    const double kept = percent * relief.kept(points);
    Result_table::Named_numbers row = {
        {"roughness, % of the spacing", percent * roughness(points) / before},
        {"relief kept, %", kept},
        {"spacing CV", spacing(points).variation},
        {"holes of the surface", double(quality.borders)},
        {"length of their rims, spacings", quality.border_length / before},
        {"mean bend of edges, degrees", quality.bend}};
    if (surface)
      row.emplace_back(
          "rms error, % of the spacing",
          percent *
              Surface_errors(points, *surface, std::vector<char>(points.size(), false)).all.rms() /
              before);
    table.add(title, row);
    cloud.add_points(title + "|roughness " + text(row[0].second, 1) + "%, relief kept " +
                         text(kept, 0) + "%",
                     points);
    mesh.add_mesh(title + "|" + std::to_string(quality.borders) + " holes, mean bend " +
                      text(quality.bend, 1) + " degrees",
                  points, triangles);
  };
  add(surface ? "a: scan, noise added" : "a: scan", scan);
  add("b: dynamic balanced flow (9)",
      run_flow(scan, CGAL::Point_set_flow::Balanced_flow(), {s.steps(12), 4}));
  add("c: bilateral", bilateral_denoising(scan, 20, 4));
  add("d: Laplacian", laplacian(scan, 20, 4));
  add("e: this package, defaults", point_set_flow(scan).points);
  if (surface)
    add("f: scan without the noise", detail);
  cloud.write_table(table);
}

inline Points read_scan(const std::string& file)
{
  Points points;
  if (!CGAL::IO::read_points(CGAL::data_file_path(file), std::back_inserter(points)))
    throw std::runtime_error("cannot read " + file + " of CGAL's data (libcgal-demo)");
  return points;
}

/// Fig. 9: the front of a building from a laser scan with the noise that it has, and the bunny, range scans merged
/// to a mesh with hardly any noise left, with some added
inline void scan_figures(const Run_settings& s)
{
  Points building = read_scan("points_3/building.ply");
  const auto is_behind = [](const Point_3& p) { return p.y() > -27.5; };
  building.erase(std::remove_if(building.begin(), building.end(), is_behind), building.end());
  if (s.quick)
    building.resize(3000);
  scan_figure(s, "building", building, building, nullptr);

  Unit_sphere_map map;
  std::optional<Mesh> mesh = read_mesh(CGAL::data_file_path("meshes/bunny00.off"), map);
  Points bunny = read_scan("meshes/bunny00.off");
  map.apply(bunny);
  const Mesh_surface surface(std::move(*mesh));
  if (s.quick)
    bunny.resize(3000);
  const Points noisy = add_noise(bunny, "Gaussian", .3 * spacing(bunny).mean, 5).points;
  scan_figure(s, "bunny", noisy, bunny, &surface);
}

} // namespace comparison

#endif // POINT_SET_FLOW_PAPER_SCAN_FIGURES_H
