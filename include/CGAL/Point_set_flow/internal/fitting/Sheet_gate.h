// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FITTING_SHEET_GATE_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FITTING_SHEET_GATE_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/Neighborhood_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// What is known of a point without a look at its neighbors, to spare most points the network that finds sheets:
/// the two sheets of a wall make the neighborhood thick, and the heights bimodal.
struct Sheet_gate {
  static constexpr std::size_t inputs = 3;
  std::array<double, inputs> input; ///< thickness and noise in logarithms, and the excess kurtosis

  /// \pre `neighborhood.has_sheets()`, with a positive deviation
  explicit Sheet_gate(const Neighborhood_3& neighborhood)
  {
    const double noise = std::log(neighborhood.noise() / neighborhood.deviation());
    input = {std::log(neighborhood.deviation() / neighborhood.radius()),
             (std::min)((std::max)(neighborhood.excess_kurtosis(), -2.), 2.),
             (std::min)((std::max)(noise, -3.), 3.)};
  }

  /// The logarithm of the odds that the network finds two sheets
  /// \param weights of the inputs, of their products, each pair once, and a constant
  double operator()(const float* weights) const
  {
    double sum = 0.;
    for (const double x : input)
      sum += double(*weights++) * x;
    for (std::size_t i = 0; i < inputs; ++i)
      for (std::size_t j = i; j < inputs; ++j)
        sum += double(*weights++) * input[i] * input[j];
    return sum + double(*weights);
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FITTING_SHEET_GATE_H
