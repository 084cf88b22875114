// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_BLOCKS_JOIN_H
#define BALANCED_FLOW_BLOCKS_JOIN_H

#include "Manifest.h"
#include "Progress.h"
#include "smooth.h"

namespace balanced_flow_blocks {

/// Writes each input with its smoothed points.
/// \return what was found and done, of all blocks
balanced_flow_smooth::Smoothing_report join(const Manifest& manifest, const Progress& progress);

} // namespace balanced_flow_blocks

#endif // BALANCED_FLOW_BLOCKS_JOIN_H
