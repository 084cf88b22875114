// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_NOISE_ANALYZED_POINTS_H
#define CGAL_POINT_SET_FLOW_INTERNAL_NOISE_ANALYZED_POINTS_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/noise/Noise_map.h>
#include <CGAL/Point_set_flow/internal/order/Point_buffer.h>
#include <CGAL/Point_set_flow/internal/parallel/stage_costs.h>

#include <optional>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// Points, analyzed: the distinct ones in spatial order, with their tree, their noise and their
/// spacing. Smoothing, estimating and reporting begin here.
class Analyzed_points {
  Point_buffer m_buffer;
  std::optional<Neighbor_tree> m_tree;
  std::optional<Noise_map> m_noise_map;

public:
  /// \param reference, start, constrained, noise as for `Point_buffer`; the arrays are freed as soon
  /// as they are copied in order
  template <typename ConcurrencyTag>
  Analyzed_points(Array<Point_3>&& reference, Array<Point_3>&& start,
                  const std::vector<char>& constrained, Given_noise&& noise,
                  Loops<ConcurrencyTag>& loops)
      : m_buffer(in_order(reference, start, constrained, noise, loops))
  {
    reference = Array<Point_3>(); // memory
    start = Array<Point_3>();
    noise = Given_noise();
    loops.begin_stage(stage_costs::tree);
    m_tree.emplace(m_buffer.reference, loops);
    loops.begin_stage(stage_costs::scale);
    m_noise_map.emplace(Scale_samples(*m_tree, loops), loops);
  }

  Analyzed_points(const Analyzed_points&) = delete; // the tree knows where the points are
  Analyzed_points& operator=(const Analyzed_points&) = delete;

  Point_buffer& buffer() { return m_buffer; }
  const Point_buffer& buffer() const { return m_buffer; }
  /// \pre `forget_points()` was not called
  const Neighbor_tree& tree() const { return *m_tree; }
  const Noise_map& noise_map() const { return *m_noise_map; }

  /// Saves memory: leaves `buffer().site_of` and the noise map only.
  void forget_points()
  {
    m_tree.reset();
    m_buffer.reference = Array<Point_3>();
    m_buffer.start = Array<Point_3>();
    m_buffer.constrained = std::vector<char>();
    m_buffer.noise = Given_noise();
  }

private:
  template <typename ConcurrencyTag>
  static Point_buffer in_order(const Array<Point_3>& reference, const Array<Point_3>& start,
                               const std::vector<char>& constrained, const Given_noise& noise,
                               Loops<ConcurrencyTag>& loops)
  {
    loops.begin_stage(stage_costs::order, 2);
    return Point_buffer(reference, start, constrained, noise, loops);
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_NOISE_ANALYZED_POINTS_H
