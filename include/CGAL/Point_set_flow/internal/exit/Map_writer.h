// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_EXIT_MAP_WRITER_H
#define CGAL_POINT_SET_FLOW_INTERNAL_EXIT_MAP_WRITER_H

#include <CGAL/license/Point_set_flow.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// Writes values to a property map, and restores the old ones unless told to keep the new: if
/// anything throws in between, the map has its old values again.
template <typename Range, typename Map, typename Value>
class Map_writer {
  Range& m_range;
  Map* m_map;
  std::vector<Value> m_values; // replaced by the old ones where written
  std::size_t m_written = 0;
  bool m_is_kept = false;

public:
  /// \param map null to write nothing
  /// \param values for each element of the range
  Map_writer(Range& range, Map* map, std::vector<Value>&& values)
      : m_range(range), m_map(map), m_values(std::move(values))
  {}

  Map_writer(const Map_writer&) = delete;
  Map_writer& operator=(const Map_writer&) = delete;

  void write()
  {
    if (!m_map)
      return;
    for (auto it = m_range.begin(); m_written != m_values.size(); ++it) {
      const Value value = m_values[m_written];
      m_values[m_written] = get(*m_map, *it);
      ++m_written; // before writing: a map that throws may have written
      put(*m_map, *it, value);
    }
  }

  void keep() { m_is_kept = true; }

  ~Map_writer()
  {
    if (m_is_kept)
      return;
    try {
      auto it = m_range.begin();
      for (std::size_t i = 0; i < m_written; ++it, ++i)
        put(*m_map, *it, m_values[i]);
    }
    catch (...) {
      // a map that cannot be written anymore; the first exception is the informative one
    }
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_EXIT_MAP_WRITER_H
