// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_SMOOTH_SMOOTH_H
#define BALANCED_FLOW_SMOOTH_SMOOTH_H

#include "command_line/Settings.h"
#include "point_files/Point_file.h"

#include <CGAL/Point_set_flow/Smoothing_report.h>

#include <functional>
#include <vector>

namespace balanced_flow_smooth {

typedef CGAL::Point_set_flow::Smoothing_report Smoothing_report;

/// Whether a normal is one: files mark those that are not known by null vectors or NaN.
bool is_known(const point_files::Vector_3& normal);

/// Smooths points where they are; `NaN` if the callback says no. Normals that are not known, null
/// vectors and those that are not finite, stay unless `s.fills_normals`; without a step all that are
/// known stay.
/// \param report receives what was found, used and done
double smooth(std::vector<point_files::Point_3>& points,
              std::vector<point_files::Vector_3>& normals, const Smoothing_settings& s,
              const std::function<bool(double)>& callback, Smoothing_report& report);

/// Finds out what `smooth()` will find and use.
Smoothing_report analyze(const std::vector<point_files::Point_3>& points,
                         const Smoothing_settings& s, const std::function<bool(double)>& callback);

/// Throws `std::invalid_argument` if the library refuses a parameter.
void check(const Smoothing_settings& s);

} // namespace balanced_flow_smooth

#endif // BALANCED_FLOW_SMOOTH_SMOOTH_H
