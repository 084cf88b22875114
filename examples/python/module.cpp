// SPDX-License-Identifier: GPL-3.0-or-later
// The compiled part of the module balanced_flow: arrays in, the library without the interpreter's lock, a
// report out. Arguments are checked and converted in balanced_flow/_arguments.py.
#include "Interpreter_callback.h"
#include "Task.h"

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <exception>
#include <list>
#include <stdexcept>

namespace py = pybind11;
using namespace balanced_flow_python;

namespace {

/// The arguments of a call, with the memory of all arrays that they name
class Arguments {
  const py::dict& m_arguments;
  std::list<py::buffer_info> m_used; // keep the memory where it is

public:
  explicit Arguments(const py::dict& arguments) : m_arguments(arguments) {}

  py::object operator[](const char* name) const { return m_arguments[name]; }

  template <typename T>
  void get(const char* name, T& to) const
  {
    to = m_arguments[name].cast<T>();
  }

  const py::buffer_info* array(const char* name, bool is_written = false)
  {
    const py::object array = m_arguments[name];
    if (array.is_none())
      return nullptr;
    return &m_used.emplace_back(array.cast<py::buffer>().request(is_written));
  }

  template <typename FT>
  Rows<FT> rows(const char* name, bool is_written = false)
  {
    const py::buffer_info* info = array(name, is_written);
    if (!info)
      return {};
    // the memory of arrays without elements may be anything, but normals must be seen to be given
    static char nothing;
    return {info->size == 0 ? &nothing : static_cast<char*>(info->ptr), info->strides[0],
            info->strides[1]};
  }

  template <typename Number>
  const Number* numbers(const char* name)
  {
    const py::buffer_info* info = array(name);
    return info ? static_cast<const Number*>(info->ptr) : nullptr;
  }
};

Parameters read_parameters(const Arguments& arguments)
{
  Parameters p;
  arguments.get("flow", p.flow);
  arguments.get("curvature", p.curvature);
  arguments.get("k", p.k);
  arguments.get("noise", p.noise);
  arguments.get("sharpness_angle", p.sharpness_angle);
  arguments.get("step_length", p.step_length);
  arguments.get("number_of_iterations", p.number_of_iterations);
  arguments.get("number_of_relaxation_steps", p.number_of_relaxation_steps);
  arguments.get("update_period", p.update_period);
  arguments.get("block_size", p.block_size);
  arguments.get("neighbor_radius", p.neighbor_radius);
  arguments.get("threads", p.threads);
  return p;
}

py::dict to_dict(const Smoothing_report& r)
{
  using py::arg;
  return py::dict(
      arg("number_of_points") = r.number_of_points,
      arg("number_of_distinct_points") = r.number_of_distinct_points, arg("noise") = r.noise,
      arg("spacing") = r.spacing, arg("fewest_neighbors") = r.fewest_neighbors,
      arg("most_neighbors") = r.most_neighbors,
      arg("number_of_iterations") = r.number_of_iterations,
      arg("number_of_relaxation_steps") = r.number_of_relaxation_steps,
      arg("filter_width") = r.filter_width, arg("feature_threshold") = r.feature_threshold,
      arg("mean_movement") = r.mean_movement, arg("last_movement") = r.last_movement,
      arg("number_of_moved_points") = r.number_of_moved_points,
      arg("number_of_constrained_points") = r.number_of_constrained_points,
      arg("number_of_isolated_points") = r.number_of_isolated_points,
      arg("number_of_points_without_noise") = r.number_of_points_without_noise,
      arg("number_of_points_at_rest") = r.number_of_points_at_rest);
}

/// Runs a function of the library on arrays of `float` or `double`.
template <typename FT, typename Function>
py::object run(const py::dict& dict, const Function& function)
{
  Arguments arguments(dict);
  Task<FT> task;
  task.parameters = read_parameters(arguments);
  task.size = std::size_t(py::len(arguments["points"]));
  task.points = arguments.rows<FT>("points");
  task.normals = arguments.rows<FT>("normals");
  task.new_points = arguments.rows<FT>("out", true);
  task.new_normals = arguments.rows<FT>("out_normals", true);
  task.noise = arguments.numbers<double>("noise_of_each");
  task.scans = arguments.numbers<std::uint32_t>("scans");
  task.constrained = arguments.numbers<std::uint8_t>("constrained");
  Interpreter_callback callback(arguments["callback"]);
  task.callback = std::ref(callback);

  std::optional<Smoothing_report> report;
  {
    const py::gil_scoped_release unlock;
    report = function(task);
  }
  callback.rethrow();
  return report ? py::object(to_dict(*report)) : py::none();
}

py::object call_smooth(const py::dict& arguments, bool is_float)
{
  return is_float ? run<float>(arguments, smooth<float>) : run<double>(arguments, smooth<double>);
}

py::object call_analyze(const py::dict& arguments, bool is_float)
{
  return is_float ? run<float>(arguments, analyze<float>) : run<double>(arguments, analyze<double>);
}

} // namespace

PYBIND11_MODULE(_core, module)
{
  py::register_local_exception_translator([](std::exception_ptr exception) {
    try {
      std::rethrow_exception(exception);
    }
    catch (const std::overflow_error& e) { // the flow diverges: a parameter was too large
      PyErr_SetString(PyExc_ValueError, e.what());
    }
  });
  module.def("smooth", call_smooth, "Writes to 'out' and 'out_normals'; None if canceled.");
  module.def("analyze", call_analyze, "What smooth() would find and use; None if canceled.");
}
