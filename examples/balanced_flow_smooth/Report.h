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

/// How points moved
struct Movement {
  std::size_t number_of_points = 0; // that moved
  double mean = 0.;                 // over all points
};

/// What became of one file
struct File_report {
  Job job;
  std::string status = "ok", message; // "ok", "failed" or "interrupted", and why
  std::string format, output_format;
  std::size_t points = 0;
  std::size_t invalid_points = 0;
  bool drops_invalid = false;
  std::size_t scans = 0;
  bool normals = false;
  std::size_t unknown_normals = 0; // in the input: null vectors, and those that are not finite
  std::vector<std::pair<std::string, std::size_t>> roles; // see `point_files::Point_file`
  std::string roles_source;
  std::optional<Movement> movement; // of a scan among others, if it was smoothed
  std::vector<std::string> warnings;
};

/// What became of files that were smoothed as one: all of them, or one alone
struct Scene_report {
  std::vector<File_report> files;
  std::optional<std::size_t> sided_points;   // whose side the scanner tells; empty if there is none
  std::optional<Smoothing_report> smoothing; // empty if that failed
  double seconds = 0.;

  /// The sum over the files
  std::size_t sum(std::size_t File_report::*number) const;
};

/// Prints a report for people.
void print_summary(std::ostream& out, const Scene_report& r, const Settings& settings);

/// Writes all reports where the settings say, as JSON for programs.
void write_json(const std::vector<Scene_report>& reports, const Settings& settings);

} // namespace balanced_flow_smooth

#endif // BALANCED_FLOW_SMOOTH_REPORT_H
