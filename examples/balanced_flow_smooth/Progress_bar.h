// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_SMOOTH_PROGRESS_BAR_H
#define BALANCED_FLOW_SMOOTH_PROGRESS_BAR_H

#include "Interrupt.h"

#include <CGAL/Real_timer.h>

#include <cstddef>
#include <iostream>
#include <string>

namespace balanced_flow_smooth {

/// Draws a progress bar, at most ten times a second, and stops the run after Ctrl-C.
class Progress_bar {
  bool m_visible;
  CGAL::Real_timer m_timer;
  double m_drawn = -1.;

public:
  explicit Progress_bar(bool visible) : m_visible(visible) { m_timer.start(); }

  bool operator()(double share)
  {
    if (m_visible && (share == 1. || m_timer.time() - m_drawn > .1)) {
      m_drawn = m_timer.time();
      const std::size_t width = 40, done = std::size_t(share * double(width));
      std::cerr << "\r[" << std::string(done, '=') << std::string(width - done, ' ') << "] "
                << int(100. * share) << "%" << (share == 1. ? "\n" : "") << std::flush;
    }
    return interrupt == 0;
  }
};

} // namespace balanced_flow_smooth

#endif // BALANCED_FLOW_SMOOTH_PROGRESS_BAR_H
