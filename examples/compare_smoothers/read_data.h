// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef COMPARISON_READ_DATA_H
#define COMPARISON_READ_DATA_H

#include "Settings.h"
#include "measure/measure.h"
#include "measure/read_mesh.h"

namespace comparison {

/// What the smoothers get, and what is known of the truth; says what that is.
/// \param map how the data were taken to the unit sphere
Noisy_data read_data(const Settings& s, Unit_sphere_map& map);

} // namespace comparison

#endif // COMPARISON_READ_DATA_H
