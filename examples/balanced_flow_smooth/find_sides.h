// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_SMOOTH_FIND_SIDES_H
#define BALANCED_FLOW_SMOOTH_FIND_SIDES_H

#include "smooth.h"

#include <cstddef>

namespace balanced_flow_smooth {

/// Whether a normal is one: files mark those that are not known by null vectors or NaN.
bool is_known(const point_files::Vector_3& normal);

/// Whether the view of a point is to tell its side.
/// \param normal given for the point; null if there is none
bool needs_view(const point_files::Vector_3& view, const point_files::Vector_3& normal);

/// The settings with which the normals of each scan are found
Smoothing_settings settings_of_normals(const Smoothing_settings& s);

/// A normal of a scan, turned to the scanner; a null vector if the view grazes and tells nothing.
point_files::Vector_3 side_by_view(const point_files::Vector_3& view,
                                   const point_files::Vector_3& normal);

/// Tells sides by the views where no normals do: by the normals of each scan, turned to its scanner. Grazing
/// views tell nothing. Leaves all as it is if the callback says no.
/// \return the number of points whose side the views tell
std::size_t find_sides(Cloud& cloud, const Smoothing_settings& s, const Callback& callback);

} // namespace balanced_flow_smooth

#endif // BALANCED_FLOW_SMOOTH_FIND_SIDES_H
