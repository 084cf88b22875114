// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_SMOOTH_SMOOTH_H
#define BALANCED_FLOW_SMOOTH_SMOOTH_H

#include "command_line/Settings.h"
#include "point_files/Point_file.h"

#include <CGAL/Point_set_flow/Coordinate_frame.h>
#include <CGAL/Point_set_flow/Smoothing_report.h>

#include <cstddef>
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

/// What is known of points that are not in memory, a model of `PointSetHalo`
class Halo {
public:
  virtual ~Halo() = default;
  virtual double distance_to_missing(const point_files::Point_3& p) const = 0;
  virtual void require(const point_files::Point_3& center, double radius) = 0;
};

/// Smooths the first `block_size` of some points, see `CGAL::Point_set_flow::smooth_block()`.
/// \return whether the halo sufficed; throws nothing and returns `true` if the callback said no
bool smooth_block(std::vector<point_files::Point_3>& points,
                  std::vector<point_files::Vector_3>& normals, std::size_t block_size,
                  const CGAL::Point_set_flow::Coordinate_frame& frame, Halo& halo,
                  const Smoothing_settings& s, const std::function<bool(double)>& callback,
                  Smoothing_report& report);

/// Finds out what `smooth()` will find and use.
Smoothing_report analyze(const std::vector<point_files::Point_3>& points,
                         const Smoothing_settings& s, const std::function<bool(double)>& callback);

/// Throws `std::invalid_argument` if the library refuses a parameter.
void check(const Smoothing_settings& s);

} // namespace balanced_flow_smooth

#endif // BALANCED_FLOW_SMOOTH_SMOOTH_H
