// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FLOW_MOVES_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FLOW_MOVES_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/neighbors/Surface.h>
#include <CGAL/Point_set_flow/internal/parallel/Compact_vector_3.h>

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// How the points move: in the last step, since the update of the reference, and in all steps. In neighborhood
/// radii, since the range of `float` is small.
class Moves {
  typedef Array<Compact_vector_3> Vectors;

  const Neighbor_graph& m_graph;
  Array<Compact_tangent_plane_3>& m_last;
  Array<float> m_last_lengths; // empty as long as the moves themselves are there
  Vectors m_all, m_since_update;
  bool m_is_updated = false;

public:
  /// \param last receives the moves of the last step. The next tangent planes come there, too: of both, only one is
  /// needed at a time.
  Moves(const Neighbor_graph& graph, Array<Compact_tangent_plane_3>& last)
      : m_graph(graph), m_last(last)
  {}

  /// Makes the reference where the points are now.
  /// \param is_last_step whether the step that follows is the last one: in that step no point is away from it
  void update_reference(bool is_last_step)
  {
    m_is_updated = true;
    m_since_update = Vectors(is_last_step ? 0 : m_all.size(), Compact_vector_3());
  }
  /// To be called when the neighborhoods are final.
  void begin_step(std::size_t n)
  {
    m_last.resize(n);
    m_all.resize(n);
  }

  void set(std::size_t i, const Vector_3& move)
  {
    m_last[i] = Compact_tangent_plane_3(move / unit(i));
    m_all[i] = Compact_vector_3(m_all[i].vector() + m_last[i].normal());
    if (!m_since_update.empty())
      m_since_update[i] = Compact_vector_3(m_since_update[i].vector() + m_last[i].normal());
  }
  /// in the step at hand
  Vector_3 operator[](std::size_t i) const { return unit(i) * m_last[i].normal(); }
  /// from the reference to where a point was before the step
  Vector_3 from_reference(std::size_t i) const
  {
    const Vectors& moves = m_is_updated ? m_since_update : m_all;
    return moves.empty() ? Vector_3(NULL_VECTOR) : unit(i) * moves[i].vector();
  }

  /// To be called after the last step. Leaves of it the lengths only.
  void finish()
  {
    m_last_lengths.reserve(m_last.size());
    for (const Compact_tangent_plane_3& move : m_last)
      m_last_lengths.push_back(float(std::sqrt(move.normal().squared_length())));
    m_last = Array<Compact_tangent_plane_3>();
    m_since_update = Vectors();
  }
  /// The length of the last move
  double last_length(std::size_t i) const
  {
    return m_last_lengths.empty() ? 0. : unit(i) * double(m_last_lengths[i]);
  }

  /// What all steps took off each point, along its normal. Forgets the moves of all steps.
  Array<double> residuals(const Surface_state& state)
  {
    Array<double> result(m_all.size());
    for (std::size_t i = 0; i < m_all.size(); ++i)
      result[i] = -unit(i) * (m_all[i].vector() * state.planes[i].normal());
    m_all = Vectors();
    return result;
  }

private:
  double unit(std::size_t i) const { return m_graph.radius(i) > 0. ? m_graph.radius(i) : 1.; }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FLOW_MOVES_H
