// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_SMOOTH_RUN_H
#define BALANCED_FLOW_SMOOTH_RUN_H

#include "Report.h"

namespace balanced_flow_smooth {

/// Reads, smooths and writes the files of a scene: all of them, or none if that fails.
/// \param report with the jobs; receives what became of them
/// \return whether it is done: it is not after Ctrl-C
bool run(const Settings& settings, Scene_report& report);

} // namespace balanced_flow_smooth

#endif // BALANCED_FLOW_SMOOTH_RUN_H
