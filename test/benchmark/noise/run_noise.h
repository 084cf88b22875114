// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_BENCHMARK_RUN_NOISE_H
#define POINT_SET_FLOW_BENCHMARK_RUN_NOISE_H

#include "Benchmark_shapes.h"
#include "Targets.h"
#include "field/run_field.h"
#include "punet/Punet_case.h"

#include "measure/Noise_models.h"
#include "measure/sample_mesh.h"

#include <CGAL/estimate_point_set_noise.h>

namespace comparison {

/// estimate_point_set_noise() beside the noise that was added.
class Noise_benchmark {
  unsigned int m_seed;
  bool m_quick;

  /// How far the estimate is off, as a factor less 1
  static double print_row(const std::string& name, double spacing, double noise,
                          const Points& points)
  {
    const double found = CGAL::estimate_point_set_noise<Concurrency_tag>(points);
    const double off = (std::min)(99., (std::max)(found / noise, noise / found) - 1.);
    std::printf("| %s | %zu | %.3f | %.3f | **%.2f** |\n", name.c_str(), points.size(),
                noise / spacing, found / spacing, found / noise);
    std::fflush(stdout);
    return off;
  }

  Points with_noise(const Points& clean, double sigma) const
  {
    return add_noise(clean, "Gaussian", sigma, m_seed + 10).points;
  }

  void run_smooth(Targets& targets) const
  {
    Ratios ratios;
    for (const char* shape : {"sphere", "waves"}) {
      const std::size_t n = m_quick ? 2000 : 10000;
      std::unique_ptr<const Mesh_surface> mesh;
      Points clean;
      if (shape == std::string("waves")) {
        mesh = load_shape(shape, n);
        clean = sample_mesh(*mesh, n, m_seed).points;
      }
      else
        clean = random_sphere(n);
      const double h = std::sqrt((mesh ? mesh->area() : 4. * CGAL_PI) / double(n));
      for (const double noise : {.03, .06, .12, .25, .5, 1., 2.}) {
        if (m_quick && noise != .25)
          continue;
        ratios.add(print_row(shape, h, noise * h, with_noise(clean, noise * h)),
                   std::string(shape) + ", " + std::to_string(noise));
      }
    }
    targets.all_at_most(.15, 8, "noise, how far off, smooth shapes", ratios);
  }

  Points random_sphere(std::size_t n) const
  {
    std::mt19937 random(m_seed);
    Points points;
    while (points.size() < n) {
      const double x = unit_noise("", random), y = unit_noise("", random);
      const Vector_3 d(x, y, unit_noise("", random));
      points.push_back(CGAL::ORIGIN + d / std::sqrt(d.squared_length()));
    }
    return points;
  }

  void run_field_clouds(Targets& targets) const
  {
    Ratios ratios;
    for (const Variation& variation : field_variations(m_seed, m_quick))
      for (const auto& make : field_cloud_makers(variation)) {
        const Test_cloud cloud = make();
        if (!cloud.normals.empty())
          continue; // layers: what is noise there, and what is not?
        ratios.add(print_row(cloud.name, cloud.spacing, cloud.error_of(cloud.points), cloud.points),
                   cloud.name + ", " + std::to_string(cloud.points.size()));
      }
    targets.all_at_most(.3, 8, "noise, how far off, field clouds", ratios);
  }

  /// Plates of two spacings and more, and parts of meshes
  void run_thin_walls(Targets& targets) const
  {
    Ratios ratios;
    for (const std::string& shape : Names{"plate-2", "plate-3", "plate-4", "blade", "turbine"}) {
      const std::size_t n = m_quick ? 2000 : 10000;
      const std::unique_ptr<const Mesh_surface> mesh = load_shape(shape, n);
      if (!mesh || (m_quick && shape != "plate-2"))
        continue;
      const Points clean = sample_mesh(*mesh, n, m_seed).points;
      const double h = std::sqrt(mesh->area() / double(n));
      for (const double noise : {.1, .25, .5})
        ratios.add(print_row(shape, h, noise * h, with_noise(clean, noise * h)),
                   shape + ", " + std::to_string(noise));
    }
    targets.all_at_most(.3, 8, "noise, how far off, thin walls", ratios);
  }

  /// Whose noise the names of the files say
  void run_punet(const std::string& folder, Targets& targets) const
  {
    Ratios ratios;
    for_each_punet_case(folder, {10000}, [&](const Punet_case& c) {
      const std::string name = c.shape + ", " + c.group.noise;
      const double h = std::sqrt(c.surface->area() / double(c.group.n)) * c.mesh_sphere.radius;
      ratios.add(print_row(name, h, std::stod(c.group.noise) * c.cloud_sphere.radius, c.noisy), name);
    });
    targets.all_at_most(.3, 8, "noise, how far off, PU-Net's shapes", ratios);
  }

public:
  Noise_benchmark(unsigned int seed, bool quick) : m_seed(seed), m_quick(quick) {}

  /// \param punet the folder of PU-Net's test set, or nothing
  void run(const std::string& punet, Targets& targets) const
  {
    std::printf("\n## Estimates of the noise\n\n| cloud | points | noise in spacings | estimate | "
                "estimate/noise |\n|---|---|---|---|---|\n");
    run_smooth(targets);
    run_field_clouds(targets);
    run_thin_walls(targets);
    if (!punet.empty())
      run_punet(punet, targets);
  }
};

} // namespace comparison

#endif // POINT_SET_FLOW_BENCHMARK_RUN_NOISE_H
