// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_BLOCKS_PROGRESS_H
#define BALANCED_FLOW_BLOCKS_PROGRESS_H

#include <functional>

namespace balanced_flow_blocks {

/// Thrown when the user interrupts: what is done stays, what is not is left as it was.
struct Interrupted {};

/// Told how much of its work is done; throws `Interrupted` if it says no.
class Progress {
  std::function<bool(double)> m_callback;
  double m_begin = 0., m_end = 1.;

public:
  explicit Progress(std::function<bool(double)> callback) : m_callback(std::move(callback)) {}

  void operator()(double share) const
  {
    if (!m_callback(m_begin + share * (m_end - m_begin)))
      throw Interrupted();
  }

  /// A part of the work
  Progress part(double begin, double end) const
  {
    Progress part = *this;
    part.m_begin = m_begin + begin * (m_end - m_begin);
    part.m_end = m_begin + end * (m_end - m_begin);
    return part;
  }
};

} // namespace balanced_flow_blocks

#endif // BALANCED_FLOW_BLOCKS_PROGRESS_H
