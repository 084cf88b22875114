// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FLOW_MOVES_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FLOW_MOVES_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/neighbors/Block.h>
#include <CGAL/Point_set_flow/internal/parallel/Vector_array.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// The length of 1 of the moves of a point with a neighborhood: the range of `float` is small.
inline double unit_of_moves(double radius) { return radius > 0. ? radius : 1.; }

/// How the points move: in the last step, and from their reference points, those of the data and, after an update,
/// those of the flow
class Moves {
  typedef Array<Compact_vector_3> Vectors;

  const Neighbor_graph& m_graph;
  Vector_array& m_last;
  Vectors m_all, m_since_update;
  bool m_is_updated = false;

public:
  /// \param last receives the moves of the last step. The next normals come there, too: of both, only one is
  /// needed at a time.
  Moves(const Neighbor_graph& graph, Vector_array& last) : m_graph(graph), m_last(last) {}

  /// To be called before the first step, when the neighborhoods are final.
  /// \param points where they start
  /// \param reference empty if they start there
  void start(const Array<Point_3>& points, const Array<Point_3>& reference)
  {
    m_all.resize(points.size());
    for (std::size_t i = 0; i < reference.size(); ++i)
      m_all[i] = (points[i] - reference[i]) / unit(i);
  }
  /// Makes the reference where the points are now.
  /// \param is_last_step whether the step that follows is the last one: in that step no point is away from it
  void update_reference(bool is_last_step)
  {
    m_is_updated = true;
    m_since_update = Vectors(is_last_step ? 0 : m_all.size(), Compact_vector_3());
  }
  void begin_step() { m_last.resize(m_all.size()); }

  /// Takes the move of a point in the step at hand.
  void set(std::size_t i, const Vector_3& move)
  {
    m_last[i] = move * (1. / unit(i));
    m_all[i] = m_all[i].vector() + m_last[i].vector();
    if (!m_since_update.empty())
      m_since_update[i] = m_since_update[i].vector() + m_last[i].vector();
  }
  /// in the last step; null if there was none
  Vector_3 operator[](std::size_t i) const
  {
    return m_last.empty() ? Vector_3(NULL_VECTOR) : unit(i) * m_last[i].vector();
  }
  /// from the reference, which may be updated, to where a point was before the step
  Vector_3 from_reference(std::size_t i) const
  {
    const Vectors& moves = m_is_updated ? m_since_update : m_all;
    return moves.empty() ? Vector_3(NULL_VECTOR) : unit(i) * moves[i].vector();
  }

  /// To be called after the last step: forgets it.
  void finish()
  {
    m_last = Vector_array();
    m_since_update = Vectors();
  }
  /// Takes what moves a point after the last step.
  void add(std::size_t i, const Vector_3& move)
  {
    m_all[i] = m_all[i].vector() + move / unit(i);
  }

  /// What took each point off the data, along its normal, in neighborhood radii
  Array<float> residuals(const Vector_array& normals) const
  {
    Array<float> result(m_all.size());
    for (std::size_t i = 0; i < m_all.size(); ++i)
      result[i] = float(-(m_all[i].vector() * normals[i].vector()));
    return result;
  }
  Vectors&& take() { return std::move(m_all); }

private:
  double unit(std::size_t i) const { return unit_of_moves(m_graph.radius(i)); }
};

/// How far the points of the interior moved in the last step: sums over chunks, the same for any blocks
inline std::vector<double> last_distances(const Moves& moves, const Block& block)
{
  std::vector<double> sums;
  for (std::size_t i = 0; i < block.interior_size(); ++i) {
    if (i % chunk_size == 0)
      sums.push_back(0.);
    sums.back() += std::sqrt(moves[block.interior_place(i)].squared_length());
  }
  return sums;
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FLOW_MOVES_H
