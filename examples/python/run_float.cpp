// SPDX-License-Identifier: GPL-3.0-or-later
#include "run_task.h"

namespace balanced_flow_python {
template std::optional<Smoothing_report> smooth(const Task<float>&);
template std::optional<Smoothing_report> analyze(const Task<float>&);
} // namespace balanced_flow_python
