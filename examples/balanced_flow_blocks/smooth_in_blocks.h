// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_BLOCKS_SMOOTH_IN_BLOCKS_H
#define BALANCED_FLOW_BLOCKS_SMOOTH_IN_BLOCKS_H

#include "Report.h"

#include <functional>

namespace balanced_flow_blocks {

/// Smooths a file within the memory of the settings: plan, run and join in a directory for temporary files,
/// which is removed.
/// \param scene of one file; has the job, and receives what was found and done
/// \return whether it is done: it is not if the callback said no
bool smooth_in_blocks(const balanced_flow_smooth::Settings& settings,
                      balanced_flow_smooth::Scene_report& scene,
                      const std::function<bool(double)>& callback);

} // namespace balanced_flow_blocks

#endif // BALANCED_FLOW_BLOCKS_SMOOTH_IN_BLOCKS_H
