// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_PARALLEL_PROGRESS_H
#define CGAL_POINT_SET_FLOW_INTERNAL_PARALLEL_PROGRESS_H

#include <CGAL/license/Point_set_flow.h>

#include <algorithm>
#include <functional>
#include <utility>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// Thrown by `Progress` when the caller's callback returns `false`, and caught by the public
/// function: no stage has to know that a run can be canceled.
struct Canceled {};

/// Reports the share of the work that is done to the caller's callback, always from the thread
/// that called the public function, so that exceptions of the callback reach the caller.
class Progress {
  std::function<bool(double)> m_callback;
  double m_total;
  double m_share = 1.;     // of the points that the current stages process
  double m_done = 0.;      // of m_total
  double m_stage_end = 0.; // what will be done at the end of the stage
  double m_loop_cost = 0.; // of each loop of the stage
  int m_loops = 0;         // that the stage has yet to run

public:
  /// \param callback may be empty
  /// \param total the cost of all stages, in any unit
  Progress(std::function<bool(double)> callback, double total)
      : m_callback(std::move(callback)), m_total(total)
  {}

  /// What follows costs `cost`, spread evenly over a number of loops. Further loops are free.
  void begin_stage(double cost, int loops = 1)
  {
    m_done = m_stage_end;
    m_stage_end += m_share * cost;
    m_loop_cost = m_share * cost / loops;
    m_loops = loops;
    ask();
  }

  /// The stages that follow work on a share of the points only.
  void set_share(double share) { m_share = share; }

  /// Gives the callback an opportunity to cancel.
  void ask() const { report((std::min)(m_done / m_total, .999)); }

  void finish() const { report(1.); }

protected:
  /// \return the cost of the loop that begins
  double begin_loop() { return m_loops > 0 ? (--m_loops, m_loop_cost) : 0.; }

  void advance(double cost)
  {
    m_done = (std::min)(m_done + cost, m_stage_end);
    ask();
  }

private:
  void report(double share) const
  {
    if (m_callback && !m_callback(share))
      throw Canceled();
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_PARALLEL_PROGRESS_H
