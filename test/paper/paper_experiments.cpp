// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the data of the paper's figures, from experiments like the paper's, and the tables of numbers.
// make_figures.sh makes the pictures of them.
#include "anisotropy_figure.h"
#include "band_figure.h"
#include "convergence_figure.h"
#include "cube_figure.h"
#include "diffusivity_figure.h"
#include "plank_figure.h"
#include "scan_figures.h"
#include "shrinkage_figure.h"

#include <boost/program_options.hpp>

#include <functional>

using namespace comparison;

namespace options = boost::program_options;

namespace {

struct Experiment {
  std::string name;
  std::function<void(const Run_settings&)> run;
};

const std::vector<Experiment> experiments = {
    {"fig2", shrinkage_figure}, {"fig3", diffusivity_figure}, {"fig4", anisotropy_figure},
    {"fig5", band_figure},      {"fig6", convergence_figure}, {"fig7", cube_figure},
    {"fig8", plank_figure},     {"fig9", scan_figures},
};

int run(int argc, char** argv)
{
  Run_settings settings;
  std::string folder;
  std::vector<std::string> names;
  options::options_description description(
      "Usage: paper_experiments [options]\n\nRepeats the experiments of the paper.\n\nOptions");
  // clang-format off
  description.add_options()
    ("help,h", "print this text")
    ("output,o", options::value(&folder)->default_value("paper"), "folder of the results")
    ("figures", options::value(&names)->multitoken(), "some of: fig2 fig3 fig4 fig5 fig6 fig7 fig8 fig9; all by default")
    ("quick", options::bool_switch(&settings.quick), "few points and steps, to see that it runs");
  // clang-format on
  options::variables_map given;
  options::store(options::parse_command_line(argc, argv, description), given);
  options::notify(given);
  if (given.count("help")) {
    std::cout << description;
    return EXIT_SUCCESS;
  }
  for (const std::string& name : names)
    if (std::none_of(experiments.begin(), experiments.end(),
                     [&](const Experiment& e) { return e.name == name; }))
      throw std::invalid_argument("there is no figure \"" + name + "\"");
  settings.folder = folder;
  std::filesystem::create_directories(settings.folder);
  for (const Experiment& e : experiments)
    if (names.empty() || std::find(names.begin(), names.end(), e.name) != names.end())
      e.run(settings);
  return EXIT_SUCCESS;
}

} // namespace

int main(int argc, char** argv)
{
  try {
    return run(argc, argv);
  }
  catch (const std::exception& error) {
    std::cerr << "paper_experiments: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }
}
