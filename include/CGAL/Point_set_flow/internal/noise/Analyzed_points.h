// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_NOISE_ANALYZED_POINTS_H
#define CGAL_POINT_SET_FLOW_INTERNAL_NOISE_ANALYZED_POINTS_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/noise/Scale_map.h>
#include <CGAL/Point_set_flow/internal/noise/choose_samples.h>
#include <CGAL/Point_set_flow/internal/order/Input_points.h>
#include <CGAL/Point_set_flow/internal/order/Point_buffer.h>
#include <CGAL/Point_set_flow/internal/parallel/stage_costs.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// Points, analyzed: the distinct ones in spatial order, with their tree, their noise and their
/// spacing. Smoothing, estimating and reporting begin here.
class Analyzed_points {
  Point_buffer m_buffer;
  Clearance m_clearance;
  std::optional<Neighbor_tree> m_tree;
  Neighbor_graph m_graph;
  std::optional<Scale_map> m_scale_map;
  Array<std::uint32_t> m_part_of;

public:
  /// \param input is freed as soon as it is copied in order
  /// \param likely_size of the neighborhoods of all points that will be needed later; 0 if none will
  /// \param block_size how many points may have their neighbors in memory at a time, if none will be needed later
  template <typename ConcurrencyTag>
  Analyzed_points(Input_points&& input, std::size_t likely_size, std::size_t block_size,
                  Loops<ConcurrencyTag>& loops)
      : m_buffer(in_order(input, loops)),
        m_clearance(input.clearance, m_buffer.site_of, m_buffer.size())
  {
    input = Input_points(); // memory
    loops.begin_stage(stage_costs::tree);
    m_tree.emplace(m_buffer.reference, loops);
    if (likely_size == 0 && m_clearance.is_whole() && m_buffer.size() > block_size) {
      const std::vector<std::uint32_t> sites = choose_samples_in_blocks(*m_tree, block_size, loops);
      find_scales([&](const Certainty&) { return sites; }, loops);
    }
    else {
      loops.begin_stage(stage_costs::graph);
      m_graph = Neighbor_graph(*m_tree, {(std::max)(likely_size, choice_size)}, loops);
      find_scales(
          [&](Certainty& certainty) {
            return choose_samples(m_buffer.reference, m_graph, certainty, loops);
          },
          loops);
      if (likely_size == 0)
        m_graph = Neighbor_graph(); // memory
    }
    m_part_of = m_scale_map->nearest_samples(m_buffer.reference, loops);
  }

  Analyzed_points(const Analyzed_points&) = delete; // the tree knows where the points are
  Analyzed_points& operator=(const Analyzed_points&) = delete;

  Point_buffer& buffer() { return m_buffer; }
  const Point_buffer& buffer() const { return m_buffer; }
  const Clearance& clearance() const { return m_clearance; }
  /// \pre `forget_points()` was not called
  const Neighbor_tree& tree() const { return *m_tree; }
  /// The nearest neighbors of all points, as many as seemed likely to be needed
  Neighbor_graph& graph() { return m_graph; }
  /// \pre neither `forget_scales()` nor `forget_points()` was called
  const Scale_map& scale_map() const { return *m_scale_map; }
  /// for each point, the nearest sample of the scale map: the points around a sample make a part
  Array<std::uint32_t>& part_of() { return m_part_of; }
  const Array<std::uint32_t>& part_of() const { return m_part_of; }

  /// Saves memory, when it is planned how points are smoothed of which none are missing.
  void forget_scales() { m_scale_map.reset(); }

  /// Saves memory: leaves `buffer().site_of` only.
  void forget_points()
  {
    m_tree.reset();
    m_graph = Neighbor_graph();
    m_scale_map.reset();
    m_buffer.reference = Array<Point_3>();
    m_buffer.start = Array<Point_3>();
    m_buffer.constrained = std::vector<char>();
    m_buffer.noise = Given_noise();
    m_buffer.sides = Array<Vector_3>();
    m_part_of = Array<std::uint32_t>();
  }

private:
  template <typename Choose, typename ConcurrencyTag>
  void find_scales(const Choose& choose, Loops<ConcurrencyTag>& loops)
  {
    loops.begin_stage(stage_costs::scale, Scale_map::number_of_loops + 1);
    m_scale_map.emplace(*m_tree, choose, m_buffer.sides, m_buffer.scans, m_clearance, loops);
    m_buffer.scans = Array<std::uint32_t>(); // memory
  }

  template <typename ConcurrencyTag>
  static Point_buffer in_order(const Input_points& input, Loops<ConcurrencyTag>& loops)
  {
    loops.begin_stage(stage_costs::order, 2);
    Point_buffer buffer(input.reference, input.start, input.constrained, input.noise, loops);
    buffer.add_layers(input.sides, input.scans);
    return buffer;
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_NOISE_ANALYZED_POINTS_H
