// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_SMOOTHING_REPORT_H
#define CGAL_POINT_SET_FLOW_SMOOTHING_REPORT_H

#include <CGAL/license/Point_set_flow.h>

#include <cstddef>

namespace CGAL {
namespace Point_set_flow {

/// \ingroup PkgPointSetFlowFunctions
/// What was found in a point set, which parameters follow from it, and how the points moved. Lengths
/// are in the unit of the data.
///
/// Noise, spacing, number of neighbors and \f$K\f$ are found around each point. The medians in this
/// report, over about one point of 18, describe the point set; nothing is decided by them.
struct Smoothing_report {
  /// the number of points
  std::size_t number_of_points = 0;
  /// the number of distinct points: exact duplicates move as one
  std::size_t number_of_distinct_points = 0;
  /// the standard deviation of the noise, given or estimated: the median
  double noise = 0.;
  /// the square root of the surface area per point: the median
  double spacing = 0.;
  /// the smallest number of neighbors of a point; it may be smaller where two sheets are close to each
  /// other
  unsigned int fewest_neighbors = 0;
  /// the largest number of neighbors of a point
  unsigned int most_neighbors = 0;
  /// the number of steps
  unsigned int number_of_iterations = 0;
  /// the number of steps of relaxation along the surface after them
  unsigned int number_of_relaxation_steps = 0;
  /// \f$\sigma\f$ in multiples of the neighborhood radius; it is larger where a given `k` is smaller
  /// than suits the noise
  double filter_width = 0.;
  /// the constant \f$K\f$ of the diffusivity: the median, unless given
  double feature_threshold = 0.;
  /// the mean distance between the points before and after; 0 if they were analyzed only
  double mean_movement = 0.;
  /// the mean distance that the distinct points moved in the last step of the flow; 0 if they were analyzed only
  double last_movement = 0.;

  /// the number of points that moved. It and the next four numbers add up to the number of points; all
  /// are 0 if the points were analyzed only.
  std::size_t number_of_moved_points = 0;
  /// the number of points that did not move because they, or duplicates of them, are constrained
  std::size_t number_of_constrained_points = 0;
  /// the number of points that did not move because they have fewer than two neighbors, or are far from
  /// all others: their neighborhood radius is more than four times that of each of their neighbors
  std::size_t number_of_isolated_points = 0;
  /// the number of points that did not move because their noise is 0, given or estimated
  std::size_t number_of_points_without_noise = 0;
  /// the number of points that did not move for other reasons: they lie in a plane with their
  /// neighbors, or no step was made
  std::size_t number_of_points_at_rest = 0;
};

} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_SMOOTHING_REPORT_H
