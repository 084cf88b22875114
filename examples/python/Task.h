// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_PYTHON_TASK_H
#define BALANCED_FLOW_PYTHON_TASK_H

#include "Array_map.h"

#include <CGAL/Point_set_flow/Smoothing_report.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace balanced_flow_python {

typedef CGAL::Point_set_flow::Smoothing_report Smoothing_report;

/// The named parameters of the library that are numbers or names; what is empty is left to the library
struct Parameters {
  std::string flow, curvature;
  std::optional<unsigned int> k;
  std::optional<double> noise, sharpness_angle, step_length;
  std::optional<std::int64_t> number_of_iterations;
  std::int64_t number_of_relaxation_steps = 0, update_period = 0, block_size = 0;
  double neighbor_radius = 0.;
  int threads = 0; ///< 0 for as many as there are
};

/// What a function of the module is called with. The arrays belong to the caller.
/// \tparam FT the type of the coordinates, `float` or `double`
template <typename FT>
struct Task {
  Parameters parameters;
  std::size_t size = 0;     ///< the number of points
  Rows<FT> points, normals; ///< normals are optional
  Rows<FT> new_points, new_normals;
  const double* noise = nullptr; ///< of each point; or null
  const std::uint32_t* scans = nullptr;
  const std::uint8_t* constrained = nullptr;
  std::function<bool(double)> callback;
};

/// Smooths points.
/// \return the report, or nothing if the callback has canceled
template <typename FT>
std::optional<Smoothing_report> smooth(const Task<FT>& task);

/// Finds out what `smooth()` would find and use.
/// \return the report, or nothing if the callback has canceled
template <typename FT>
std::optional<Smoothing_report> analyze(const Task<FT>& task);

} // namespace balanced_flow_python

#endif // BALANCED_FLOW_PYTHON_TASK_H
