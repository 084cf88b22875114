// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FITTING_MEAN_AND_SQUARES_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FITTING_MEAN_AND_SQUARES_H

#include <CGAL/license/Point_set_flow.h>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// The mean of numbers and the sum of the squares of their differences from it, updated number by
/// number (Welford): the difference of two large sums would lose digits.
struct Mean_and_squares {
  double count = 0., mean = 0., squares = 0.;

  void add(double x)
  {
    count += 1.;
    const double before = x - mean;
    mean += before / count;
    squares += before * (x - mean);
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FITTING_MEAN_AND_SQUARES_H
