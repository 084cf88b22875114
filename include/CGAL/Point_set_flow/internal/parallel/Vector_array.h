// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_PARALLEL_VECTOR_ARRAY_H
#define CGAL_POINT_SET_FLOW_INTERNAL_PARALLEL_VECTOR_ARRAY_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/Compact_vector_3.h>
#include <CGAL/Point_set_flow/internal/parallel/Array.h>

#include <cstddef>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// Vectors, and behind them what `Surface_estimate_3::normals` needs
class Vector_array {
  Array<Compact_vector_3> m_vectors; // and one more

public:
  void resize(std::size_t n) { m_vectors.resize(n + 1); }
  void assign(const Array<Vector_3>& vectors)
  {
    m_vectors.assign(vectors.begin(), vectors.end());
    m_vectors.emplace_back();
  }
  bool empty() const { return m_vectors.empty(); }
  Compact_vector_3& operator[](std::size_t i) { return m_vectors[i]; }
  const Compact_vector_3& operator[](std::size_t i) const { return m_vectors[i]; }
  const Compact_vector_3* data() const { return m_vectors.data(); }
  void swap(Vector_array& other) { m_vectors.swap(other.m_vectors); }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_PARALLEL_VECTOR_ARRAY_H
