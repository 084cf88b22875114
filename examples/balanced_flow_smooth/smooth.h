// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_SMOOTH_SMOOTH_H
#define BALANCED_FLOW_SMOOTH_SMOOTH_H

#include "Cloud.h"
#include "command_line/Settings.h"

#include <CGAL/Point_set_flow/Coordinate_frame.h>
#include <CGAL/Point_set_flow/Smoothing_report.h>

#include <cstddef>
#include <functional>

namespace balanced_flow_smooth {

typedef CGAL::Point_set_flow::Smoothing_report Smoothing_report;
typedef std::function<bool(double)> Callback; // as those of the library

/// Which points of a cloud
struct Index_range {
  std::size_t begin, end;
};

/// Smooths points where they are, and the normals if there are any, as if there were no others; nothing
/// changes if the callback says no.
/// \param report receives what was found, used and done
void smooth(Cloud& cloud, const Index_range& range, const Smoothing_settings& s,
            const Callback& callback, Smoothing_report& report);

/// What is known of points that are not in memory, a model of `PointSetHalo`
class Halo {
public:
  virtual ~Halo() = default;
  virtual double distance_to_missing(const point_files::Point_3& p) const = 0;
  virtual void require(const point_files::Point_3& center, double radius) = 0;
};

/// Smooths the first `block_size` of some points, see `CGAL::Point_set_flow::smooth_block()`.
/// \return whether the halo sufficed; throws nothing and returns `true` if the callback said no
bool smooth_block(Cloud& cloud, std::size_t block_size,
                  const CGAL::Point_set_flow::Coordinate_frame& frame, Halo& halo,
                  const Smoothing_settings& s, const Callback& callback, Smoothing_report& report);

/// Finds out what `smooth()` will find and use.
Smoothing_report analyze(const Cloud& cloud, const Smoothing_settings& s, const Callback& callback);

/// Whether a normal of a file stays as it is: one that is not known, unless `s.fills_normals`, and without a
/// step all that are known.
bool keeps_normal(const point_files::Vector_3& normal, const Smoothing_settings& s);

/// Throws `std::invalid_argument` if the library refuses a parameter.
void check(const Smoothing_settings& s);

} // namespace balanced_flow_smooth

#endif // BALANCED_FLOW_SMOOTH_SMOOTH_H
