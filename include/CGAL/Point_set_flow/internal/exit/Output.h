// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_EXIT_OUTPUT_H
#define CGAL_POINT_SET_FLOW_INTERNAL_EXIT_OUTPUT_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/exit/New_points.h>
#include <CGAL/Point_set_flow/internal/exit/new_normals.h>
#include <CGAL/Point_set_flow/internal/exit/write_all.h>
#include <CGAL/Point_set_flow/internal/flow/Block_runs.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// The results, as the caller wants them: in the order, the frame and the types of the caller.
template <typename Maps>
class Output {
  Maps& m_maps;
  const std::vector<std::uint32_t>& m_site_of;
  const Array<double>& m_strength;
  std::vector<typename Maps::Kernel_vector_3> m_normals;
  New_points<Maps> m_moved;

public:
  /// \param site_of for each point, where it is in `result`
  /// \param report receives the mean movement, and how many points moved
  template <typename ConcurrencyTag>
  Output(Maps& maps, const Frame& frame, const Flow_result& result,
         const std::vector<std::uint32_t>& site_of, Smoothing_report& report,
         const Argument_check& check, Loops<ConcurrencyTag>& loops)
      : m_maps(maps), m_site_of(site_of), m_strength(result.feature_strength),
        m_normals(new_normals(maps, result.normals, site_of)),
        m_moved(maps, frame, result, site_of, report, check, loops)
  {}

  /// Writes all, or nothing if a map throws. To be called once: the points are moved from.
  void write()
  {
    write_all(m_maps, std::move(m_moved.points), std::move(m_normals), m_strength, m_site_of);
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_EXIT_OUTPUT_H
