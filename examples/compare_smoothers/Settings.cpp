// SPDX-License-Identifier: GPL-3.0-or-later
#include "Settings.h"

#include <boost/program_options.hpp>

#include <iostream>
#include <stdexcept>

namespace comparison {

namespace options = boost::program_options;

std::optional<Settings> read_command_line(int argc, char** argv)
{
  Settings s;
  options::options_description description(
      "Usage: compare_smoothers mesh | noisy clean | scan [options]\n\n"
      "Compares smoothers: on samples of a mesh with noise added, on a noisy and a clean file "
      "with\n"
      "the same points in the same order, or on one file without a truth.\n\nOptions");
  // clang-format off
  description.add_options()
    ("help,h", "print this text")
    ("points,n", options::value(&s.n)->default_value(10000), "number of samples of a mesh")
    ("noise", options::value(&s.noise)->default_value(1.), "standard deviation of the noise, in percent of the mesh's radius")
    ("seed", options::value(&s.seed)->default_value(1), "of the samples and the noise")
    ("cloud", options::bool_switch(&s.cloud), "take the vertices of a mesh file as a scan")
    ("methods", options::value(&s.methods)->multitoken(),
     "some of: none jet bilateral wlop curvature anisotropic well-posed volume-preserving balanced ours")
    ("html", options::bool_switch(&s.html), "write a page, too, that shows the clouds side by side: of --methods, or noisy, jet, bilateral and ours")
    ("html-points", options::value(&s.html_points)->default_value(200000), "the number of points that the page draws of a cloud; of more it draws a random sample")
    ("output,o", options::value(&s.output)->default_value("comparison"), "folder of the results");
  options::options_description files;
  files.add_options()("file", options::value(&s.files)->required(), "");
  // clang-format on
  options::positional_options_description positions;
  positions.add("file", -1);
  options::variables_map given;
  options::options_description all;
  all.add(description).add(files);
  options::store(options::command_line_parser(argc, argv).options(all).positional(positions).run(),
                 given);
  if (given.count("help")) {
    std::cout << description;
    return std::nullopt;
  }
  options::notify(given);
  if (s.files.size() > 2)
    throw std::invalid_argument("one or two files");
  if (s.n < 20 || !(s.noise >= 0.))
    throw std::invalid_argument("--points must be at least 20 and --noise not negative");
  if (s.html_points < 1)
    throw std::invalid_argument("--html-points must be at least 1");
  return s;
}

} // namespace comparison
