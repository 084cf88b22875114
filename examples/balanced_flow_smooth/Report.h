// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_SMOOTH_REPORT_H
#define BALANCED_FLOW_SMOOTH_REPORT_H

#include "command_line/Settings.h"
#include "smooth.h"

#include <cstddef>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace balanced_flow_smooth {

/// What became of one file
struct File_report {
  Job job;
  std::string status = "ok", message; // "ok", "failed" or "interrupted", and why
  std::string format, output_format;
  std::size_t points = 0;
  std::size_t invalid_points = 0;
  bool drops_invalid = false;
  bool normals = false;
  std::size_t unknown_normals = 0; // in the input: null vectors, and those that are not finite
  std::vector<std::pair<std::string, std::size_t>> roles; // see `point_files::Point_file`
  std::string roles_source;
  std::optional<Smoothing_report> smoothing; // empty if that failed
  double seconds = 0.;
  std::vector<std::string> warnings;
};

/// Prints the report of one file, for people.
void print_summary(std::ostream& out, const File_report& r, const Settings& settings);

/// Writes the reports of all files where the settings say, as JSON for programs.
void write_json(const std::vector<File_report>& reports, const Settings& settings);

} // namespace balanced_flow_smooth

#endif // BALANCED_FLOW_SMOOTH_REPORT_H
