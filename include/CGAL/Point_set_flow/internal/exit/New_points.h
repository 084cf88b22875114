// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_EXIT_NEW_POINTS_H
#define CGAL_POINT_SET_FLOW_INTERNAL_EXIT_NEW_POINTS_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/entrance/Argument_check.h>
#include <CGAL/Point_set_flow/internal/entrance/Frame.h>
#include <CGAL/Point_set_flow/internal/flow/Block_runs.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// The points that are to be written, in the order of the caller.
template <typename Maps>
class New_points {
  typedef typename Maps::Kernel_point_3 Kernel_point_3;

  const bool m_is_limited;
  const Argument_check& m_check;

public:
  std::vector<Kernel_point_3> points;
  /// \param result of the distinct points; the radii of their neighborhoods limit their movement
  /// \param site_of for each point, where it is in the result
  /// \param report receives the mean movement, and how many points moved
  template <typename ConcurrencyTag>
  New_points(const Maps& maps, const Frame& frame, const Flow_result& result,
             const std::vector<std::uint32_t>& site_of, Smoothing_report& report,
             const Argument_check& check, Loops<ConcurrencyTag>& loops)
      : m_is_limited(result.is_limited), m_check(check)
  {
    const std::size_t most = 64 * chunk_size; // at a time, to save memory
    Array<Vector_3> moves((std::min)(most, site_of.size()));
    points.reserve(site_of.size());
    double movement = 0.;
    for (auto it = maps.points.begin(); it != maps.points.end(); ++it) {
      const std::size_t i = points.size();
      if (i % most == 0) // random memory access, worth parallelizing
        loops.for_each_chunk((std::min)(most, site_of.size() - i),
                             [&](std::size_t begin, std::size_t end) {
                               for (std::size_t j = begin; j < end; ++j)
                                 moves[j] = move(result, site_of[i + j]);
                             });
      // adding the movement, instead of transforming back from the frame, preserves all digits of
      // points that do not move
      const Kernel_point_3& p = get(maps.point_map, *it);
      const Vector_3& d = moves[i % most];
      movement += std::sqrt(d.squared_length()); // in the frame, where squares are in range
      points.push_back(moved(p, d * frame.unit, i));
      ++(is_same(points.back(), p) ? count_of(report, result.rest_reasons[site_of[i]])
                                   : report.number_of_moved_points);
    }
    report.mean_movement = movement / double(points.size()) * frame.unit;
  }

private:
  /// Where a point went, in the frame. It does not leave its neighborhood.
  Vector_3 move(const Flow_result& result, std::size_t site) const
  {
    const Vector_3 d = result.moves[site].vector(); // in neighborhood radii
    const double squared = d.squared_length();
    // as far as the neighborhood reaches, whose radius is rounded up
    const double most = result.radii[site].value() > 0. ? 1. - 2. * Compact_length::rounding : 0.;
    return result.unit(site) *
           (m_is_limited && squared > most ? d * (most / std::sqrt(squared)) : d);
  }

  static bool is_same(const Kernel_point_3& p, const Kernel_point_3& q)
  {
    return p.x() == q.x() && p.y() == q.y() && p.z() == q.z();
  }

  /// The moved point. It does not leave the range of its coordinates (some scans mark missing points
  /// by the largest `float`); where movement is not limited, that is an error.
  Kernel_point_3 moved(const Kernel_point_3& p, const Vector_3& d, std::size_t i) const
  {
    const auto sum = [&](auto coordinate, double distance) {
      typedef decltype(coordinate) FT;
      const FT moved = coordinate + FT(distance);
      const bool is_finite = std::isfinite(to_double(moved));
      if (!std::isfinite(distance) || !(is_finite || m_is_limited))
        m_check.diverges(" at points[" + std::to_string(i) + "]");
      return is_finite ? moved : coordinate;
    };
    return Kernel_point_3(sum(p.x(), d.x()), sum(p.y(), d.y()), sum(p.z(), d.z()));
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_EXIT_NEW_POINTS_H
