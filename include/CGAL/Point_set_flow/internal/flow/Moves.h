// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FLOW_MOVES_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FLOW_MOVES_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/neighbors/Surface.h>
#include <CGAL/Point_set_flow/internal/parallel/Compact_vector_3.h>

#include <cstddef>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// How the points move in one step, and in all of them if that is wanted. In neighborhood radii, since the range
/// of `float` is small.
class Moves {
  const Neighbor_graph& m_graph;
  Array<Compact_vector_3> m_last, m_all;
  bool m_keeps_all = false;

public:
  explicit Moves(const Neighbor_graph& graph) : m_graph(graph) {}

  /// To be called before the first step
  void keep_all() { m_keeps_all = true; }
  bool empty() const { return m_last.empty(); }
  void clear() { m_last = Array<Compact_vector_3>(); }
  void resize(std::size_t n)
  {
    m_last.resize(n);
    if (m_keeps_all)
      m_all.resize(n);
  }

  void set(std::size_t i, const Vector_3& move)
  {
    m_last[i] = Compact_vector_3(move / unit(i));
    if (m_keeps_all)
      m_all[i] = Compact_vector_3(m_all[i].vector() + m_last[i].vector());
  }
  Vector_3 operator[](std::size_t i) const { return unit(i) * m_last[i].vector(); }

  /// What all steps took off each point, along its normal. Forgets the moves of all steps.
  Array<double> residuals(const Surface_state& state)
  {
    Array<double> result(m_all.size());
    for (std::size_t i = 0; i < m_all.size(); ++i)
      result[i] = -unit(i) * (m_all[i].vector() * state.planes[i].normal());
    m_all = Array<Compact_vector_3>();
    return result;
  }

private:
  double unit(std::size_t i) const { return m_graph.radius(i) > 0. ? m_graph.radius(i) : 1.; }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FLOW_MOVES_H
