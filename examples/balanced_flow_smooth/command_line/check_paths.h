// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_SMOOTH_CHECK_PATHS_H
#define BALANCED_FLOW_SMOOTH_CHECK_PATHS_H

#include "Settings.h"

namespace balanced_flow_smooth {

/// Throws `Usage_error` if a file would be written twice, or over an input that was not asked to be
/// replaced, however the paths are spelled: `./a`, links, hard links, standard input.
void check_paths(const Settings& settings);

} // namespace balanced_flow_smooth

#endif // BALANCED_FLOW_SMOOTH_CHECK_PATHS_H
