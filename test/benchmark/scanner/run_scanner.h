// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_BENCHMARK_RUN_SCANNER_H
#define POINT_SET_FLOW_BENCHMARK_RUN_SCANNER_H

#include "Virtual_scanner.h"
#include "building_front.h"

#include "Benchmark_shapes.h"
#include "field/Comparison.h"

#include <iostream>

namespace comparison {

/// Virtual scans of shapes, and what is done with them.
class Scanner_benchmark {
  std::size_t m_n;
  unsigned int m_seed;
  bool m_quick;
  std::vector<Scan_scene> m_scenes;

  void add_front(unsigned int positions, std::mt19937& random)
  {
    const double spacing = std::sqrt(1.6 * 1.1 * 1.2 / double(m_n)); // the sides have an area, too
    std::optional<Mesh> mesh = building_front(spacing, m_seed);
    Points along_the_street;
    std::uniform_real_distribution<double> shift(-.1, .1);
    for (unsigned int i = 0; i < positions; ++i)
      along_the_street.emplace_back(1.8 * i / (positions - 1.) - .9 + shift(random), -2.5, -.5);
    m_scenes.push_back(
        {"front", std::make_shared<Mesh_surface>(std::move(*mesh)), along_the_street});
  }

  /// Calls `visit` with each of the scans.
  template <typename Visit>
  void for_each_scan(const std::vector<Scan_settings>& all, const Visit& visit) const
  {
    unsigned int seed = m_seed;
    for (const Scan_settings& settings : all)
      for (const Scan_scene& scene : m_scenes)
        visit(Virtual_scanner(scene, settings, ++seed)(m_n));
  }

  static Scan_settings settings(const std::string& name, double noise)
  {
    Scan_settings s;
    s.name = name;
    s.noise = noise;
    return s;
  }

  static std::vector<Scan_settings> noisy_scans()
  {
    std::vector<Scan_settings> all = {
        settings("noise .15", .15),        settings("noise .3", .3),   settings("noise .6", .6),
        settings("rounded ranges", .1),    settings("edge beams", .2), settings("scan lines", .2),
        settings("registration error", .1)};
    all[3].rounding = .3;
    all[4].edge_beams = true;
    all[5].line_ratio = 6.;
    all[6].registration = .5;
    return all;
  }

public:
  /// \param positions of the scanner around a shape; in front of a building half as many
  Scanner_benchmark(unsigned int seed, bool quick, unsigned int positions)
      : m_n(quick ? 3000 : 10000), m_seed(seed), m_quick(quick)
  {
    std::mt19937 random(seed);
    Names shapes = {"elephant", "fandisk", "joint", "hand", "bull", "knot1", "couplingdown"};
    if (m_quick)
      shapes = {"joint"};
    for (const std::string& shape : shapes) {
      std::shared_ptr<const Mesh_surface> surface = load_shape(shape, m_n);
      if (surface)
        m_scenes.push_back({shape, surface, positions_around(positions, random)});
      else
        std::cerr << "skipped " << shape << ": no file, or no manifold triangle mesh in it"
                  << std::endl;
    }
    add_front(positions / 2, random);
  }

  void run_noisy(Targets& targets) const
  {
    Comparison_table table("Virtual scans");
    for_each_scan(noisy_scans(), [&](const Test_cloud& cloud) {
      table.add(cloud, Comparison(cloud, Rivals::jets_and_bilateral));
    });
    const std::string what = "error to the best of nothing, jets and bilateral, scans";
    targets.mean_at_most(.78, 2, what, table.ratios());
    targets.all_at_most(1.05, 2, what, table.ratios());
  }

  /// Two surveys, so that the truth is in the middle of two layers: where each position has an error
  /// of its own, what the layers at a place have in common is most of what remains, for all alike.
  void run_registered(Targets& targets) const
  {
    Scan_settings s = settings("registration .5, normals", .1), t = s;
    s.registration = .5;
    t.name = "registration 1, normals";
    t.registration = 1.;
    s.gives_normals = t.gives_normals = s.two_surveys = t.two_surveys = true;
    for (const bool gives_scans : {false, true}) {
      s.gives_scans = t.gives_scans = gives_scans;
      const std::string what =
          gives_scans ? "scans with normals and their numbers" : "scans with normals";
      Comparison_table table("Registered " + what);
      for_each_scan({s, t}, [&](const Test_cloud& cloud) {
        table.add(cloud, Comparison(cloud, Rivals::jets_and_bilateral));
      });
      targets.mean_at_most(.8, 2, "the same, registered " + what, table.ratios());
    }
  }

  /// Scans with the little noise of a good scanner, and without any. Where there is none, there is
  /// no ratio, but a movement.
  void run_clean(Targets& targets) const
  {
    std::printf("\n## Clean scans\n\n| cloud | points | raw error in spacings | error | ours/raw | "
                "rms movement | moved |\n|---|---|---|---|---|---|---|\n");
    Ratios errors, movements;
    const std::vector<Scan_settings> all = {settings("clean", 0.), settings("noise .02", .02),
                                            settings("noise .05", .05)};
    for_each_scan(all, [&](const Test_cloud& cloud) {
      const Points smoothed = point_set_flow(cloud.points).points;
      const double h = cloud.spacing, raw = cloud.error_of(cloud.points) / h;
      const double ours = cloud.error_of(smoothed) / h;
      const double moved = movement(cloud.points, smoothed) / h;
      const double ratio = raw > 1e-6 ? ours / raw : unknown;
      std::printf("| %s | %zu | %.4f | %.4f |", cloud.name.c_str(), cloud.points.size(), raw, ours);
      std::printf(std::isnan(ratio) ? " - |" : " **%.2f** |", ratio);
      std::printf(" %.4f | %.0f%% |\n", moved, 100. * share_moved(cloud.points, smoothed));
      std::fflush(stdout);
      errors.add(ratio, cloud.name);
      if (raw < .03) // else there is a noise to be smoothed away
        movements.add(moved, cloud.name);
    });
    targets.all_at_most(1.05, 3, "error to the raw one, clean scans", errors);
    targets.all_at_most(.05, 3, "rms movement in spacings, clean scans", movements);
  }
};

} // namespace comparison

#endif // POINT_SET_FLOW_BENCHMARK_RUN_SCANNER_H
