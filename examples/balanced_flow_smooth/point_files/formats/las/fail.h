// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_FILES_LAS_FAIL_H
#define POINT_FILES_LAS_FAIL_H

#include <cstddef>
#include <sstream>
#include <stdexcept>
#include <string>

namespace point_files::las {

/// Throws `std::runtime_error` with a message made of words and numbers.
template <typename... Words>
[[noreturn]] void fail(const Words&... words)
{
  std::ostringstream message;
  message.precision(17);
  (message << ... << words);
  throw std::runtime_error(message.str());
}

inline std::string axis_name(std::size_t axis) { return std::string(1, char('x' + int(axis))); }

} // namespace point_files::las

#endif // POINT_FILES_LAS_FAIL_H
