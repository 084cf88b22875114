// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef COMPARISON_RUN_IN_CHILD_H
#define COMPARISON_RUN_IN_CHILD_H

#include "Smoothers.h"

#include <functional>
#include <optional>

namespace comparison {

/// What came of a smoother, and at what cost
struct Run {
  Smoothed smoothed;
  double seconds;
  double megabytes; ///< peak memory above that before the run; NaN where it can not be measured
};

/// Runs a smoother in a process of its own, so that its peak memory is its own and a crash is not
/// ours. Empty if it failed. Must not be called after TBB has started threads here: they would be
/// missing in the child.
/// \param prepare is called in that process before it is measured
std::optional<Run> run_in_child(
    const std::function<Smoothed()>& smooth, const std::function<void()>& prepare = []() {});

} // namespace comparison

#endif // COMPARISON_RUN_IN_CHILD_H
