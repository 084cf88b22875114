// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_SMOOTH_SMOOTH_H
#define BALANCED_FLOW_SMOOTH_SMOOTH_H

#include "command_line/Settings.h"
#include "point_files/Point_file.h"

#include <functional>
#include <optional>
#include <vector>

namespace balanced_flow_smooth {

/// What the program decided, and what it found out
struct Parameters {
  double noise = 0., spacing = 0.;
  unsigned int fewest_neighbors = 0, most_neighbors = 0;
  double filter_width = 0., feature_threshold = 0.;
};

/// Smooths points where they are; `NaN` if the callback says no.
double smooth(std::vector<point_files::Point_3>& points,
              std::vector<point_files::Vector_3>& normals, const Smoothing_settings& s,
              const std::function<bool(double)>& callback);

/// Throws `std::invalid_argument` if the library refuses a parameter.
void check(const Smoothing_settings& s);

/// Finds out what `smooth()` will do, with the parts of the package that decide it; empty if the
/// callback says no.
std::optional<Parameters> find_parameters(const std::vector<point_files::Point_3>& points,
                                          const Smoothing_settings& s,
                                          const std::function<bool(double)>& callback);

} // namespace balanced_flow_smooth

#endif // BALANCED_FLOW_SMOOTH_SMOOTH_H
