// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_ENTRANCE_ARGUMENT_CHECK_H
#define CGAL_POINT_SET_FLOW_INTERNAL_ENTRANCE_ARGUMENT_CHECK_H

#include <CGAL/license/Point_set_flow.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// Refuses bad arguments of a public function, in release builds too. The messages name the function
/// and the argument, and show the value.
class Argument_check {
  std::string m_function;

public:
  /// \param function its name, with namespaces
  explicit Argument_check(const char* function) : m_function(function) {}

  const std::string& function() const { return m_function; }

  template <typename T>
  [[noreturn]] void refuse(const std::string& argument, const T& value,
                           const std::string& requirement) const
  {
    std::ostringstream message;
    message.precision(17);
    message << m_function << ": " << argument << " is " << value << ", but " << requirement;
    throw std::invalid_argument(message.str());
  }

  void finite_and_not_negative(const char* argument, double value) const
  {
    if (!(value >= 0. && std::isfinite(value)))
      refuse(argument, value, "must be finite and not negative");
  }

  /// \param i the number of an element of the argument
  void finite_and_not_negative(const char* argument, std::size_t i, double value) const
  {
    if (!(value >= 0. && std::isfinite(value)))
      finite_and_not_negative((argument + ("[" + std::to_string(i) + "]")).c_str(), value);
  }

  /// Converts a number of any type that a user may pass for a count.
  template <typename Number>
  unsigned int count(const char* argument, Number value) const
  {
    static_assert(std::is_arithmetic<Number>::value, "a number is expected here");
    const double number = static_cast<double>(value);
    if (!(number >= 0. && number <= double((std::numeric_limits<std::int32_t>::max)()) &&
          std::floor(number) == number))
      refuse(argument, value, "must be a whole number from 0 to 2147483647");
    return static_cast<unsigned int>(value);
  }

  [[noreturn]] void diverges(const std::string& where = "") const
  {
    throw std::overflow_error(m_function + ": the flow diverges" + where +
                              ", try a smaller step_length");
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_ENTRANCE_ARGUMENT_CHECK_H
