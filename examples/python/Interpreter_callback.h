// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_PYTHON_INTERPRETER_CALLBACK_H
#define BALANCED_FLOW_PYTHON_INTERPRETER_CALLBACK_H

#include <pybind11/pybind11.h>

#include <chrono>
#include <exception>
#include <utility>

namespace balanced_flow_python {

/// What the library calls while it runs without the interpreter's lock: takes the lock from time to time,
/// looks for signals such as Ctrl-C, and tells the progress to the caller's function.
///
/// Exceptions of Python are kept until the library has returned, so that none of them passes through it.
class Interpreter_callback {
  typedef std::chrono::steady_clock Clock;
  // Another thread of Python may hold the lock for 5 ms each time we want it
  static constexpr std::chrono::milliseconds interval{50};

  pybind11::object m_callback; // or None
  Clock::time_point m_next;    // the first call is always passed on
  std::exception_ptr m_exception;

public:
  explicit Interpreter_callback(pybind11::object callback) : m_callback(std::move(callback)) {}
  Interpreter_callback(const Interpreter_callback&) = delete;
  Interpreter_callback& operator=(const Interpreter_callback&) = delete;

  /// \return whether to go on
  bool operator()(double share)
  {
    const Clock::time_point now = Clock::now();
    if (now < m_next && share != 1.)
      return true;
    m_next = now + interval;
    const pybind11::gil_scoped_acquire lock;
    try {
      return tell(share);
    }
    catch (...) {
      m_exception = std::current_exception();
      return false;
    }
  }

  /// Throws what was thrown meanwhile. The lock must be held.
  void rethrow()
  {
    if (m_exception)
      std::rethrow_exception(std::exchange(m_exception, nullptr));
  }

private:
  bool tell(double share) const
  {
    if (PyErr_CheckSignals() != 0)
      throw pybind11::error_already_set();
    if (m_callback.is_none())
      return true;
    const pybind11::object goes_on = m_callback(share);
    if (goes_on.is_none()) // of a function that returns nothing
      return true;
    const int truth = PyObject_IsTrue(goes_on.ptr());
    if (truth < 0)
      throw pybind11::error_already_set();
    return truth != 0;
  }
};

} // namespace balanced_flow_python

#endif // BALANCED_FLOW_PYTHON_INTERPRETER_CALLBACK_H
