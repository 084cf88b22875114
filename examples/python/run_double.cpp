// SPDX-License-Identifier: GPL-3.0-or-later
#include "run_task.h"

namespace balanced_flow_python {
template std::optional<Smoothing_report> smooth(const Task<double>&);
template std::optional<Smoothing_report> analyze(const Task<double>&);
} // namespace balanced_flow_python
