// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_BLOCKS_SMOOTH_ONE_H
#define BALANCED_FLOW_BLOCKS_SMOOTH_ONE_H

#include "Manifest.h"
#include "Progress.h"

#include <cstddef>

namespace balanced_flow_blocks {

/// Smooths a block with the halo that it needs, and writes the result. If it is there already, nothing is done.
void smooth_one(const Manifest& manifest, std::size_t block, const Progress& progress);

} // namespace balanced_flow_blocks

#endif // BALANCED_FLOW_BLOCKS_SMOOTH_ONE_H
