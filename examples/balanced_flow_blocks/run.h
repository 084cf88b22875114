// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_BLOCKS_RUN_H
#define BALANCED_FLOW_BLOCKS_RUN_H

#include "Manifest.h"
#include "Progress.h"

#include <cstddef>

namespace balanced_flow_blocks {

/// Smooths all blocks that are not smoothed yet.
/// \param jobs the number of processes
void smooth_all(const Manifest& manifest, unsigned int jobs, const Progress& progress);

std::size_t number_of_results(const Manifest& manifest);

} // namespace balanced_flow_blocks

#endif // BALANCED_FLOW_BLOCKS_RUN_H
