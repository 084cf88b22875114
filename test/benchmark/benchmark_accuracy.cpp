// SPDX-License-Identifier: GPL-3.0-or-later
// How close to the true surface this package comes, with its defaults, beside the smoothers of CGAL
// with the best of their settings and APSS: shapes x noise x sampling densities, where the truth is
// known. Prints Markdown tables, rows as they are done, and a table of the project's targets.
//   benchmark_accuracy [--groups ...] [--points ...] [--noise ...] [--shapes ...] [--quick]
// Lengths in thousandths of the radius of the shape.
#include "Benchmark_shapes.h"
#include "Cost_curve.h"
#include "Outcome_table.h"

#include "measure/sample_mesh.h"

#include <boost/program_options.hpp>

using namespace comparison;

namespace options = boost::program_options;

namespace {

struct Settings {
  Names groups, shapes;
  std::vector<std::size_t> points;
  std::vector<double> noise;
  unsigned int seed;
  std::string csv;
  bool quick;

  bool has(const std::string& group) const
  {
    return std::find(groups.begin(), groups.end(), group) != groups.end();
  }
};

std::optional<Settings> read_command_line(int argc, char** argv)
{
  Settings s;
  options::options_description description("Options");
  // clang-format off
  description.add_options()
    ("help,h", "print this text")
    ("groups", options::value(&s.groups)->multitoken()->default_value({"tuned", "untuned", "thin", "conditions", "clean", "k", "normals"}, "all"),
     "some of: tuned untuned thin conditions clean k normals cost; the last five with the first number of --points only")
    ("points", options::value(&s.points)->multitoken()->default_value({10000, 50000}, "10000 50000"), "numbers of samples")
    ("noise", options::value(&s.noise)->multitoken()->default_value({.5, 1., 2., 3.}, "0.5 1 2 3"), "in percent of the radius")
    ("shapes", options::value(&s.shapes)->multitoken(), "only these of the groups' shapes; mesh files are taken as untuned shapes")
    ("seed", options::value(&s.seed)->default_value(1), "of the samples and the noise")
    ("csv", options::value(&s.csv), "file for all numbers")
    ("quick", options::bool_switch(&s.quick), "a few small cases, whose figures mean little");
  // clang-format on
  options::variables_map given;
  options::store(options::parse_command_line(argc, argv, description), given);
  if (given.count("help")) {
    std::cout << "Usage: benchmark_accuracy [options]\n\n" << description;
    return std::nullopt;
  }
  options::notify(given);
  if (s.quick) {
    s.points = {2000};
    s.noise = {1.};
    s.shapes = {"fandisk", "joint", "plate-4", "waves", "box"};
  }
  if (s.points.empty() || s.noise.empty())
    throw std::invalid_argument("--points and --noise need a number");
  return s;
}

/// Shape by shape, runs the cases of a group.
class Benchmark {
  const Settings& m_settings;
  Outcome_table m_table;
  Outcome_targets m_outcomes;
  Targets m_targets;

  /// Calls `visit` with each shape of those wanted, and samples of it
  template <typename Visit>
  void for_each_shape(const Names& shapes, const std::vector<std::size_t>& points,
                      bool varying_density, const Visit& visit)
  {
    for (const std::size_t n : points)
      for (const std::string& shape : shapes) {
        const Names& wanted = m_settings.shapes;
        if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), shape) == wanted.end())
          continue;
        const std::unique_ptr<Mesh_surface> surface = load_shape(shape, n);
        if (!surface) {
          std::cerr << "skipped " << shape << ": no file, or no manifold triangle mesh in it"
                    << std::endl;
          continue;
        }
        const Samples clean = varying_density
                                  ? sample_mesh(*surface, n, m_settings.seed, tenfold_density)
                                  : sample_mesh(*surface, n, m_settings.seed);
        visit(shape, *surface, clean);
      }
  }

  Accuracy_case make_case(const std::string& group, const std::string& shape,
                          const std::string& condition, std::size_t n, double noise) const
  {
    return {group, shape, condition, n, noise, m_settings.seed + 10};
  }

  static double spacing_of(const Mesh_surface& surface, std::size_t n)
  {
    return std::sqrt(surface.area() / double(n));
  }

  void run_accuracy(const std::string& group, const Names& shapes,
                    const std::vector<std::size_t>& points, const std::string& condition)
  {
    for_each_shape(shapes, points, condition == "density",
                   [&](const std::string& shape, const Mesh_surface& surface, Samples clean) {
                     for (const double noise : m_settings.noise) {
                       const std::size_t n = clean.points.size();
                       find_samples_near_edges(clean, surface,
                                               2. * spacing_of(surface, n) + 3. * noise / 100.);
                       const Outcome outcome =
                           run_case(make_case(group, shape, condition, n, noise), surface, clean,
                                    group == "normals");
                       group == "normals" ? print_normals(outcome) : m_table.add(outcome);
                       m_outcomes.add(outcome);
                     }
                   });
  }

  static void print_normals(const Outcome& outcome)
  {
    std::printf("| %s |", outcome.what.name().c_str());
    for (const double error : outcome.normal_errors)
      std::printf(" %.2f |", error);
    std::printf("\n");
    std::fflush(stdout);
  }

  void run_conditions()
  {
    Outcome_table::print_header("Other noise, other samples, other shapes");
    const std::vector<std::size_t> points = {m_settings.points.front()};
    for (const char* condition :
         {"directional", "uniform", "Laplace", "varying", "outliers", "density"})
      run_accuracy("conditions", {"fandisk", "elephant", "joint", "hand"}, points, condition);
    run_accuracy("conditions", {"waves", "three_peaks", "mannequin-devil", "lion-head"}, points,
                 "open");
    run_accuracy("conditions", {"box", "wedge-30", "prism-30"}, points, "creases");
  }

  void run_clean()
  {
    std::printf("\n## Clean input\n\n| shape | points | rms movement in spacings | rms error in "
                "spacings |\n|---|---|---|---|\n");
    Ratios movements;
    Names shapes = tuned_shapes();
    for (const Names& more :
         {untuned_shapes(), thin_shapes(), Names{"waves", "box", "wedge-30", "prism-30"}})
      shapes.insert(shapes.end(), more.begin(), more.end());
    for_each_shape(
        shapes, {m_settings.points.front()}, false,
        [&](const std::string& shape, const Mesh_surface& surface, const Samples& clean) {
          const std::size_t n = clean.points.size();
          const Points smoothed = point_set_flow(clean.points).points;
          const double h = spacing_of(surface, n);
          const double moved = movement(clean.points, smoothed) / h;
          const Surface_errors errors(smoothed, surface, std::vector<char>(n, false));
          std::printf("| %s | %zu | %.4f | %.4f |\n", shape.c_str(), n, moved,
                      errors.all.rms() / h);
          std::fflush(stdout);
          movements.add(moved, shape);
        });
    m_targets.all_at_most(.05, 6, "rms movement of clean points in spacings", movements);
  }

  void run_given_k()
  {
    std::printf("\n## k given\n\n| shape | k | jet | bilateral | ours | ratio "
                "|\n|---|---|---|---|---|---|\n");
    Ratios ratios;
    for_each_shape(
        {"fandisk", "elephant", "armadillo", "joint", "hand", "dino"}, {m_settings.points.front()},
        false, [&](const std::string& shape, const Mesh_surface& surface, const Samples& clean) {
          for (const double noise : m_settings.noise)
            for (const unsigned int k : {12u, 24u, 48u}) {
              const auto what = make_case("k", shape, "Gaussian", clean.points.size(), noise);
              const Points noisy =
                  add_noise(clean.points, "Gaussian", noise / 100., what.seed).points;
              const auto rms = [&](const Smoothed& smoothed) {
                return 1e3 * Surface_errors(smoothed.points, surface,
                                            std::vector<char>(noisy.size(), false))
                                 .all.rms();
              };
              const double of_jet = rms(jet(noisy, k)), of_bilateral = rms(bilateral(noisy, k));
              const double ours = rms(point_set_flow(noisy, k));
              const double ratio = ours / (std::min)(of_jet, of_bilateral);
              std::printf("| %s | %u | %.2f | %.2f | %.2f | **%.2f** |\n", what.name().c_str(), k,
                          of_jet, of_bilateral, ours, ratio);
              std::fflush(stdout);
              ratios.add(ratio, what.name() + ", k=" + std::to_string(k));
            }
        });
    m_targets.all_at_most(1., 7, "rms to the better of jet and bilateral with the same k", ratios);
  }

  void run_cost()
  {
    Cost_curve curve;
    for_each_shape(
        {"fandisk", "elephant", "camel", "joint", "hand", "dino"}, {m_settings.points.front()},
        false, [&](const std::string& shape, const Mesh_surface& surface, const Samples& clean) {
          for (const double noise : m_settings.noise) {
            const auto what = make_case("cost", shape, "Gaussian", clean.points.size(), noise);
            curve.add(add_noise(clean.points, "Gaussian", noise / 100., what.seed).points, surface,
                      what.name());
          }
        });
    curve.print();
  }

public:
  explicit Benchmark(const Settings& settings) : m_settings(settings), m_table(settings.csv) {}

  void run()
  {
    std::printf(
        "rms distances to the surface x 1000, shapes of radius 1, seed %u. jet, bilateral and "
        "APSS with the best of their settings in each case.\nratio: to the better of jet and "
        "bilateral. peer: that one. near edges: the same for points near edges over 30 degrees.\n",
        m_settings.seed);
    Names untuned = untuned_shapes();
    std::copy_if(m_settings.shapes.begin(), m_settings.shapes.end(), std::back_inserter(untuned),
                 is_file);
    const std::pair<const char*, Names> groups[] = {
        {"tuned", tuned_shapes()}, {"untuned", untuned}, {"thin", thin_shapes()}};
    for (const auto& [group, shapes] : groups)
      if (m_settings.has(group)) {
        Outcome_table::print_header(std::string("Shapes, ") + group);
        run_accuracy(group, shapes, m_settings.points, "Gaussian");
      }
    if (m_settings.has("conditions"))
      run_conditions();
    if (m_settings.has("normals")) {
      std::printf(
          "\n## Normals, mean error in degrees\n\n| shape | ours | PCA of noisy | jet of noisy | "
          "PCA of best peer's | jet of best peer's |\n|---|---|---|---|---|---|\n");
      run_accuracy("normals", {"fandisk", "elephant", "joint", "hand"}, {m_settings.points.front()},
                   "Gaussian");
    }
    if (m_settings.has("clean"))
      run_clean();
    if (m_settings.has("k"))
      run_given_k();
    if (m_settings.has("cost"))
      run_cost();
    m_outcomes.write_to(m_targets);
    m_targets.print();
  }
};

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
    std::cerr << "benchmark_accuracy: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }
}
