// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_PARALLEL_PROGRESS_H
#define CGAL_POINT_SET_FLOW_INTERNAL_PARALLEL_PROGRESS_H

#include <algorithm>
#include <functional>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// Thrown by `Progress` when the caller's callback returns `false`, and caught by the public
/// function: no stage has to know that a run can be cancelled.
struct Cancelled {};

/// Reports the share of the work that is done to the caller's callback, always from the thread
/// that called the public function, so that whatever the callback throws gets back to the caller.
class Progress {
  const std::function<bool(double)>& m_callback;
  double m_total, m_done = 0.;

public:
  /// \param total the whole work, in any unit
  Progress(const std::function<bool(double)>& callback, double total)
      : m_callback(callback), m_total(total)
  {}

  void advance(double work)
  {
    m_done += work;
    report((std::min)(m_done / m_total, .999));
  }

  void finish() { report(1.); }

private:
  void report(double share) const
  {
    if (m_callback && !m_callback(share))
      throw Cancelled();
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_PARALLEL_PROGRESS_H
