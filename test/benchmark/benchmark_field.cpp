// SPDX-License-Identifier: GPL-3.0-or-later
// How close to the true surface this package comes on data as it comes from the field, with its
// defaults, beside doing nothing and the smoothers of CGAL with the best of their settings:
// generated clouds, virtual scans, and real ones from folders. Prints Markdown tables, rows as they
// are done, and a table of the project's targets.
//   benchmark_field [--groups ...] [--scans DIR] [--punet DIR] [--punet-others DIR...] [--seed ...] [--quick]
// Errors are rms distances to the true surface of the points that were measured on it.
#include "field/run_field.h"
#include "noise/run_noise.h"
#include "pairs/run_pairs.h"
#include "punet/run_punet.h"
#include "relief/run_relief.h"
#include "scanner/run_scanner.h"

#include <boost/program_options.hpp>

#include <iostream>
#include <optional>

using namespace comparison;

namespace options = boost::program_options;

namespace {

struct Settings {
  std::vector<std::string> groups;
  unsigned int seed;
  std::string scans, punet;
  std::vector<std::size_t> punet_points;
  std::vector<std::string> punet_others;
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
    ("groups", options::value(&s.groups)->multitoken()->default_value({"field", "scanner", "clean", "registered", "pairs", "punet", "relief", "noise"}, "all"),
     "some of: field scanner clean registered pairs punet relief noise; pairs and punet need their folders")
    ("scans", options::value(&s.scans), "folder of real scans: X_noisy.ply, and the surface X_clean.ply, a mesh or a denser cloud")
    ("punet", options::value(&s.punet), "folder of PU-Net's test set: X_10000_clean.ply, X_10000_noisy_0.01.ply, X_mesh.off, ...")
    ("punet-points", options::value(&s.punet_points)->multitoken()->default_value({10000}, "10000"), "which of the clouds of PU-Net's test set")
    ("punet-others", options::value(&s.punet_others)->multitoken(), "folders named after other methods, with what they made of the noisy clouds, in files of the same names and in the same coordinates")
    ("seed", options::value(&s.seed)->default_value(1), "of what is generated: other seeds are other surfaces and other noise")
    ("quick", options::bool_switch(&s.quick), "a few small cases, whose figures mean little");
  // clang-format on
  options::variables_map given;
  options::store(options::parse_command_line(argc, argv, description), given);
  if (given.count("help")) {
    std::cout << "Usage: benchmark_field [options]\n\n" << description;
    return std::nullopt;
  }
  options::notify(given);
  return s;
}

void run(const Settings& s)
{
  Targets targets;
  std::printf("Errors x 1000, seed %u. ours/best: to the best of doing nothing and the others.\n",
              s.seed);
  if (s.has("field"))
    run_field(s.seed, s.quick, targets);
  if (s.has("scanner") || s.has("clean") || s.has("registered")) {
    const Scanner_benchmark scanner(s.seed, s.quick, 6);
    if (s.has("scanner"))
      scanner.run_noisy(targets);
    if (s.has("registered"))
      Scanner_benchmark(s.seed, s.quick, 12).run_registered(targets);
    if (s.has("clean"))
      scanner.run_clean(targets);
  }
  if (s.has("pairs") && !s.scans.empty())
    run_pairs(s.scans, targets);
  if (s.has("punet") && !s.punet.empty())
    Punet_benchmark(s.punet_others).run(s.punet, s.punet_points, targets);
  if (s.has("relief") && !s.quick)
    run_relief(targets);
  if (s.has("noise"))
    Noise_benchmark(s.seed, s.quick).run(s.punet, targets);
  targets.print();
}

} // namespace

int main(int argc, char** argv)
{
  try {
    const std::optional<Settings> settings = read_command_line(argc, argv);
    if (settings)
      run(*settings);
    return EXIT_SUCCESS;
  }
  catch (const std::exception& error) {
    std::cerr << "benchmark_field: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }
}
