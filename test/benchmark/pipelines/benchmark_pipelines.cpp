// SPDX-License-Identifier: GPL-3.0-or-later
// What CGAL's reconstructions and its plane detection make of points that were smoothed or not:
// raw, by jets, bilaterally, by this package. Prints Markdown tables, rows as they are done.
//   benchmark_pipelines [--cases ...] [--output folder] [--quick]
#include "Pipelines.h"
#include "Scans.h"

#include "measure/Smoothers.h"

#include <CGAL/estimate_point_set_noise.h>

#include <boost/program_options.hpp>

#include <cstdio>
#include <filesystem>
#include <iostream>
#include <map>

using namespace comparison;

namespace options = boost::program_options;

namespace {

struct Settings {
  Names cases;
  std::string output;
  std::size_t samples = 10000;
  bool quick = false;

  bool has(const std::string& name) const
  {
    return cases.empty() || std::find(cases.begin(), cases.end(), name) != cases.end();
  }
};

typedef std::function<Reconstructed(const std::string& method)> Reconstruct;

class Benchmark {
  const Settings& m_settings;

  static void print_topology(const Topology& t)
  {
    std::printf(" %zu / %zu / %ld", t.components, t.holes, t.handles);
  }

  /// CGAL's surface mesher throws where it can not go on
  static Reconstructed try_to(const Reconstruct& reconstruct, const std::string& method)
  {
    try {
      return reconstruct(method);
    }
    catch (const std::exception& error) {
      std::cerr << method << ": " << error.what() << std::endl;
      return std::nullopt;
    }
  }

  void print(const Scan& scan, const Names& methods, const char* reconstruction,
             const Reconstruct& reconstruct) const
  {
    std::printf("| %s |", scan.name.c_str());
    if (scan.topology)
      print_topology(*scan.topology);
    std::printf(" |");
    for (const std::string& method : methods) {
      const Reconstructed mesh = try_to(reconstruct, method);
      if (!mesh || mesh->number_of_faces() == 0) {
        std::printf(" failed |");
        continue;
      }
      if (!m_settings.output.empty())
        CGAL::IO::write_OFF(m_settings.output + "/" + scan.name + ", " + reconstruction + ", " +
                                method + ".off",
                            *mesh);
      print_topology(topology_of(*mesh));
      const Mesh_distances m = distances_of(*mesh, scan.truth, m_settings.samples, .03);
      if (scan.truth.surface)
        std::printf("; %.2f, %.1f%%;", 1e3 * m.to_truth, 100. * m.stray);
      else
        std::printf(";");
      std::printf(" %.2f |", 1e3 * m.from_truth);
      std::fflush(stdout);
    }
    std::printf("\n");
    std::fflush(stdout);
  }

  static void print_header(const char* title, const Names& methods)
  {
    std::printf("\n## %s\n\n| scan | truth |", title);
    for (const std::string& method : methods)
      std::printf(" %s |", method.c_str());
    std::printf("\n|---|---|");
    for (std::size_t i = 0; i < methods.size(); ++i)
      std::printf("---|");
    std::printf("\n");
  }

  std::vector<Scan> scans() const
  {
    std::vector<Scan> result;
    const auto add = [&](const char* name, const std::function<Scan()>& make) {
      if (m_settings.has(name))
        result.push_back(make());
    };
    const std::size_t n = m_settings.quick ? 1000 : 10000;
    if (m_settings.quick) {
      result.push_back(sampled("joint", "joint", "Gaussian", .01, n));
      result.push_back(as_scanned("oni", "oni.pwn"));
      return result;
    }
    add("hand", [&] { return sampled("hand", "hand", "Gaussian", .01, n); });
    add("joint", [&] { return sampled("joint", "joint", "Gaussian", .01, n); });
    add("elephant", [&] { return sampled("elephant", "elephant", "Gaussian", .01, n); });
    add("fandisk", [&] { return sampled("fandisk", "fandisk", "Gaussian", .01, n); });
    add("fandisk, directional",
        [&] { return sampled("fandisk, directional", "fandisk", "directional", .02, n); });
    add("hand, outliers", [&] {
      Scan scan = sampled("hand, outliers", "hand", "outliers", .01, n);
      scan.points = without_outliers(scan.points, 3.);
      return scan;
    });
    add("hand, outliers left",
        [&] { return sampled("hand, outliers left", "hand", "outliers", .01, n); });
    add("kitten + noise", [&] { return with_noise_added("kitten + noise", "kitten.xyz", .01); });
    add("hippo1 + noise", [&] { return with_noise_added("hippo1 + noise", "hippo1.ply", .01); });
    add("hippo1", [&] { return as_scanned("hippo1", "hippo1.ply"); });
    add("oni", [&] { return as_scanned("oni", "oni.pwn"); });
    add("building", [&] { return as_scanned("building", "building.ply"); });
    return result;
  }

  std::map<std::string, Smoothed> smooth(const Points& points) const
  {
    std::map<std::string, Smoothed> smoothed;
    smoothed["raw"] = {points, {}};
    smoothed["jet"] = jet(points, 24);
    smoothed["bilateral"] = bilateral(points, 24);
    smoothed["ours"] = point_set_flow(points);
    smoothed["ours, PCA normals"] = {smoothed["ours"].points, {}};
    return smoothed;
  }

  void run_surfaces() const
  {
    const std::vector<Scan> all = scans();
    std::vector<std::map<std::string, Smoothed>> smoothed;
    for (const Scan& scan : all)
      smoothed.push_back(smooth(scan.points));
    const Names names = {"raw", "jet", "bilateral", "ours"};

    print_header("Advancing front", names);
    for (std::size_t i = 0; i < all.size(); ++i)
      print(all[i], names, "advancing front", [&](const std::string& method) {
        return advancing_front(smoothed[i].at(method).points);
      });

    Names with_pca = names;
    with_pca.push_back("ours, PCA normals");
    for (const bool by_tree : {false, true}) {
      print_header(by_tree ? "Poisson, sides by a spanning tree" : "Poisson, sides known",
                   with_pca);
      for (std::size_t i = 0; i < all.size(); ++i) {
        const Vectors sides = by_tree ? Vectors() : all[i].sides();
        if ((!by_tree && sides.empty()) || all[i].name == "building")
          continue; // a scan without a truth: there is only the tree; the building is not closed
        print(all[i], with_pca, by_tree ? "Poisson by tree" : "Poisson",
              [&](const std::string& method) {
                const Smoothed& points = smoothed[i].at(method);
                return poisson(points.points, points.normals, sides);
              });
      }
    }

    const std::vector<std::pair<std::string, Scale_smoother>> scales = {
        {"raw", Scale_smoother::none},
        {"weighted PCA, 4 times", Scale_smoother::weighted_pca},
        {"jet, 4 times", Scale_smoother::jet},
        {"ours", Scale_smoother::point_set_flow}};
    const std::map<std::string, Scale_smoother> smoother_of(scales.begin(), scales.end());
    Names titles;
    for (const auto& scale : scales)
      titles.push_back(scale.first);
    print_header("Scale space", titles);
    for (const Scan& scan : all)
      print(scan, titles, "scale space", [&](const std::string& method) {
        return scale_space(scan.points, smoother_of.at(method));
      });
  }

  void run_planes() const
  {
    std::printf("\n## Planes\n\nepsilon in deviations of the noise of the scan, residuals in "
                "thousandths of the unit of the scan\n\n"
                "| scan | epsilon | points | planes | share of points | residual | of the scan "
                "|\n|---|---|---|---|---|---|---|\n");
    for (const char* name : {"building", "b9_training"}) {
      if (!m_settings.has(name) || (m_settings.quick && std::string(name) == "building"))
        continue;
      const Points scan = read_scan(std::string(name) + ".ply");
      const double noise = CGAL::estimate_point_set_noise<Concurrency_tag>(scan);
      const std::map<std::string, Smoothed> smoothed = smooth(scan);
      for (const double epsilon : {1., 3.})
        for (const char* method : {"raw", "jet", "bilateral", "ours", "ours, PCA normals"}) {
          const Smoothed& points = smoothed.at(method);
          const Plane_measures m = measure_planes(scan, points.points, points.normals,
                                                  epsilon * noise, m_settings.quick ? 1 : 5);
          std::printf("| %s | %.0f | %s | %.1f | %.1f%% | %.2f | %.2f |\n", name, epsilon, method,
                      m.planes, 100. * m.share, 1e3 * m.residual, 1e3 * m.of_scan);
          std::fflush(stdout);
        }
    }
  }

public:
  explicit Benchmark(const Settings& settings) : m_settings(settings) {}

  void run() const
  {
    std::printf(
        "Cells: components / holes / handles; median distance of the mesh from the true surface, "
        "share of the mesh that is farther than 30 from it; rms distance of the true points from "
        "the mesh. Lengths in thousandths of the radius.\n");
    run_surfaces();
    run_planes();
  }
};

std::optional<Settings> read_command_line(int argc, char** argv)
{
  Settings s;
  options::options_description description("Options");
  // clang-format off
  description.add_options()
    ("help,h", "print this text")
    ("cases", options::value(&s.cases)->multitoken(), "only these scans")
    ("output", options::value(&s.output), "folder for the meshes")
    ("quick", options::bool_switch(&s.quick), "a few small scans, whose figures mean little");
  // clang-format on
  options::variables_map given;
  options::store(options::parse_command_line(argc, argv, description), given);
  if (given.count("help")) {
    std::cout << "Usage: benchmark_pipelines [options]\n\n" << description;
    return std::nullopt;
  }
  options::notify(given);
  if (!s.output.empty())
    std::filesystem::create_directories(s.output);
  if (s.quick)
    s.samples = 1000;
  return s;
}

} // namespace

int main(int argc, char** argv)
{
  try {
    const std::optional<Settings> settings = read_command_line(argc, argv);
    if (settings)
      Benchmark(*settings).run();
    return EXIT_SUCCESS;
  }
  catch (const std::exception& error) {
    std::cerr << "benchmark_pipelines: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }
}
