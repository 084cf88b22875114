// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef COMPARISON_SETTINGS_H
#define COMPARISON_SETTINGS_H

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace comparison {

/// What the command line asks for
struct Settings {
  std::vector<std::string> files, methods;
  std::string output;
  std::size_t n;
  unsigned int seed;
  double noise;
  bool cloud, html;
  std::size_t html_points;
};

/// Empty after --help; throws what Boost.Program_options throws, or `std::invalid_argument`.
std::optional<Settings> read_command_line(int argc, char** argv);

} // namespace comparison

#endif // COMPARISON_SETTINGS_H
