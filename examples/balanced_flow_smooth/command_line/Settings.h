// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_SMOOTH_SETTINGS_H
#define BALANCED_FLOW_SMOOTH_SETTINGS_H

#include "point_files/Format.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace balanced_flow_smooth {

/// How to smooth; what is empty is chosen from the data
struct Smoothing_settings {
  std::string flow = "balanced", curvature = "learned";
  std::optional<unsigned int> k;
  unsigned int iterations = 0, update_period = 4, relaxation_steps = 0;
  double neighbor_radius = 0., sharpness_angle = 0., step_length = 0.;
  std::optional<double> noise, feature_threshold, filter_width;

  bool fills_normals = false; // also where the input has a normal that is not known

  bool makes_steps() const
  {
    return relaxation_steps != 0 ||
           (iterations != 0 && step_length != 0. && noise.value_or(1.) != 0.);
  }
  bool is_paper_estimator() const { return curvature == "covariance"; }
};

/// One file to be smoothed
struct Job {
  std::filesystem::path input, output; // no output in a dry run without one
  bool keeps_format = false;           // whatever the name of the output
};

/// What the command line asks for
struct Settings {
  Smoothing_settings smoothing;
  std::vector<Job> jobs;
  const point_files::Format *input_format = nullptr, *output_format = nullptr; // null: to be found
  std::vector<std::string> columns; // the names of those of text; empty: to be found
  point_files::Invalid invalid = point_files::Invalid::BY_FORMAT;
  bool zeros_are_invalid = false;
  std::string report; // the file of the JSON report, "-" for standard output, empty for none
  unsigned int threads = 0;
  bool together = false; // whether the files are scans that are smoothed as one
  bool normals = false, quiet = false, dry_run = false;
  // beyond memory
  std::string memory;         // "2G"; empty: all points are in memory
  unsigned int processes = 1; // that smooth blocks
  std::size_t block_size = 0; // points, 0: as memory allows

  bool points_to_standard_output() const
  {
    return !dry_run && !jobs.empty() && jobs.front().output == "-";
  }
};

} // namespace balanced_flow_smooth

#endif // BALANCED_FLOW_SMOOTH_SETTINGS_H
