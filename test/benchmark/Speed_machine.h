// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_BENCHMARK_SPEED_MACHINE_H
#define POINT_SET_FLOW_BENCHMARK_SPEED_MACHINE_H

#include <CGAL/Real_timer.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <limits>
#include <vector>

namespace comparison {

/// The least of the seconds that a function takes in some trials
template <typename Function>
double least_seconds(const Function& function)
{
  double least = (std::numeric_limits<double>::infinity)();
  for (int trial = 0; trial < 5; ++trial) {
    CGAL::Real_timer timer;
    timer.start();
    function();
    least = (std::min)(least, timer.time());
  }
  return least;
}

/// The bytes per second that one thread reads and writes when it copies memory that no cache holds
inline double bytes_per_second()
{
  const std::size_t n = std::size_t(1) << 28;
  std::vector<char> from(n, 1), to(n, 2);
  const double seconds = least_seconds([&] { std::memcpy(to.data(), from.data(), n); });
  return 2. * double(n) / seconds;
}

/// The multiplications and additions of floats per second of one thread, in registers as wide as this program was
/// compiled for
/// \param sink receives a number, lest the compiler leaves the arithmetic out
inline double flops_per_second(double& sink)
{
  constexpr int width = int(Eigen::internal::packet_traits<float>::size);
  typedef Eigen::Array<float, width, 1> Register;
  const std::size_t n = 20000000;
  const Register start = Register::Random();
  const double seconds = least_seconds([&] {
    // as many chains as hide the latencies, and all in registers
    const Register factor = Register::Constant(.999f), summand = Register::Constant(.001f);
    Register a = start, b = -a, c = 2.f * a, d = 3.f * a, e = 4.f * a, f = 5.f * a, g = 6.f * a;
    Register h = 7.f * a, i = 8.f * a, j = 9.f * a, k = -2.f * a, l = -3.f * a;
    for (std::size_t count = 0; count < n; ++count) {
      a = a * factor + summand, b = b * factor + summand, c = c * factor + summand;
      d = d * factor + summand, e = e * factor + summand, f = f * factor + summand;
      g = g * factor + summand, h = h * factor + summand, i = i * factor + summand;
      j = j * factor + summand, k = k * factor + summand, l = l * factor + summand;
    }
    sink += double((a + b + c + d + e + f + g + h + i + j + k + l).sum());
  });
  return 12. * 2. * double(width) * double(n) / seconds;
}

} // namespace comparison

#endif // POINT_SET_FLOW_BENCHMARK_SPEED_MACHINE_H
