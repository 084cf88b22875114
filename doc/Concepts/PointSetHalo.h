// SPDX-License-Identifier: GPL-3.0-or-later
/*!
\ingroup PkgPointSetFlowConcepts
\cgalConcept

The concept `PointSetHalo` describes what is known of the points that are missing when
`CGAL::Point_set_flow::smooth_block()` smooths some points of a larger point set.

Say the other points are in files, each with its bounding box: then the distance to the nearest box of a file
that was not read is a `distance_to_missing()`, and `require()` takes note of the files whose boxes meet
the ball.
*/
class PointSetHalo {
public:
  /// returns a distance from `p` within which no point is missing: all points of the point set that are nearer
  /// are in the range. Infinite if no points are missing at all. With `CGAL::Parallel_tag` it is called
  /// from several threads at once.
  double distance_to_missing(const Kernel::Point_3& p) const;

  /// is called if the halo is too small, for each place where points may be missing: those within `radius`
  /// should be there when `CGAL::Point_set_flow::smooth_block()` is called again. The balls are guessed, and may
  /// be larger than needed or, at the first time, not large enough. Each of them contains a place
  /// where `distance_to_missing()` said that a point may be missing.
  void require(const Kernel::Point_3& center, double radius);
};
