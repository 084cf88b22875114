// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_PYTHON_RUN_TASK_H
#define BALANCED_FLOW_PYTHON_RUN_TASK_H

#include "../balanced_flow_smooth/find_flow.h"
#include "Task.h"

#include <CGAL/Iterator_range.h>
#include <CGAL/Point_set_flow/Covariance_curvature.h>
#include <CGAL/Point_set_flow/Learned_curvature.h>
#include <CGAL/Point_set_flow/Tangent_plane_curvature.h>
#include <CGAL/Point_set_flow/analyze_point_set.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/balanced_flow_smooth_point_set.h>

#include <boost/iterator/counting_iterator.hpp>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/task_arena.h>
#endif

#include <cmath>
#include <functional>
#include <stdexcept>

// Hands a task over to the library. Included once for each type of coordinates, to be compiled apart.
namespace balanced_flow_python {

namespace flows = CGAL::Point_set_flow;
typedef CGAL::Parallel_if_available_tag Concurrency_tag;

/// Calls `run` with the flow, the estimator and its defaults.
template <typename Run>
auto with_flow(const Parameters& p, const Run& run)
{
  const auto flow = CGAL::parameters::flow(balanced_flow_smooth::find_flow(p.flow));
  if (p.curvature == "covariance")
    return run(flow.curvature(flows::Covariance_curvature()), flows::Curvature_defaults());
  const flows::Curvature_defaults defaults = flows::Learned_curvature::defaults();
  if (p.curvature == "tangent-plane")
    return run(flow.curvature(flows::Tangent_plane_curvature()), defaults);
  if (p.curvature != "learned")
    throw std::invalid_argument("curvature is '" + p.curvature +
                                "', but must be 'learned', 'tangent-plane' or 'covariance'");
  return run(flow.curvature(flows::Learned_curvature()), defaults);
}

/// Calls `run` with all named parameters, and `k` if it is given.
template <typename FT, typename Run>
void with_parameters(const Task<FT>& task, Smoothing_report& report, const Run& run)
{
  typedef CGAL::Simple_cartesian<FT> Kernel;
  const Parameters& p = task.parameters;
  with_flow(p, [&](const auto& flow, const auto& defaults) {
    const auto with_cgal = [&](const auto& own) {
      const auto all =
          own.smoothing_report(std::ref(report))
              .number_of_iterations(p.number_of_iterations.value_or(defaults.number_of_iterations))
              .number_of_relaxation_steps(p.number_of_relaxation_steps)
              .sharpness_angle(p.sharpness_angle.value_or(defaults.sharpness_angle))
              .neighbor_radius(p.neighbor_radius)
              .callback(task.callback)
              .point_is_constrained_map(Numbers_map<std::uint8_t>{task.constrained})
              .point_map(Rows_map<typename Kernel::Point_3, FT>{task.points, task.new_points})
              .normal_map(Rows_map<typename Kernel::Vector_3, FT>{task.normals, task.new_normals});
      if (p.k)
        run(all, *p.k);
      else
        run(all);
    };
    const auto own = flow.step_length(p.step_length.value_or(defaults.step_length))
                         .update_period(p.update_period)
                         .block_size(p.block_size)
                         .scan_map(Numbers_map<std::uint32_t>{task.scans});
    if (task.noise)
      with_cgal(own.noise(Numbers_map<double>{task.noise}));
    else
      with_cgal(own.noise(p.noise));
  });
}

/// Calls a function, with at most that many threads.
template <typename Function>
void with_threads(int threads, const Function& function)
{
#ifdef CGAL_LINKED_WITH_TBB
  if (threads != 0) {
    tbb::task_arena arena(threads); // in which the calling thread takes part
    arena.execute(function);
    return;
  }
#endif
  static_cast<void>(threads);
  function();
}

typedef boost::counting_iterator<std::size_t> Row;

template <typename FT>
std::optional<Smoothing_report> smooth(const Task<FT>& task)
{
  CGAL::Iterator_range<Row> rows(Row(0), Row(task.size));
  Smoothing_report report;
  bool is_done = false;
  with_threads(task.parameters.threads, [&] {
    with_parameters(task, report, [&](const auto& np, auto... k) {
      const double moved = CGAL::balanced_flow_smooth_point_set<Concurrency_tag>(rows, k..., np);
      is_done = !std::isnan(moved);
    });
  });
  return is_done ? std::optional<Smoothing_report>(report) : std::nullopt;
}

template <typename FT>
std::optional<Smoothing_report> analyze(const Task<FT>& task)
{
  const CGAL::Iterator_range<Row> rows(Row(0), Row(task.size));
  Smoothing_report report;
  with_threads(task.parameters.threads, [&] {
    with_parameters(task, report, [&](const auto& np, auto... k) {
      report = flows::analyze_point_set<Concurrency_tag>(rows, k..., np);
    });
  });
  return std::isnan(report.noise) ? std::nullopt : std::optional<Smoothing_report>(report);
}

} // namespace balanced_flow_python

#endif // BALANCED_FLOW_PYTHON_RUN_TASK_H
