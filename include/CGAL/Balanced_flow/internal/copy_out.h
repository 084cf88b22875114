// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BALANCED_FLOW_INTERNAL_COPY_OUT_H
#define CGAL_BALANCED_FLOW_INTERNAL_COPY_OUT_H

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// Swaps the values of a property map with those of a vector. If the map throws, what was written
/// so far is taken back: the map keeps its old values.
template <typename Range, typename Map, typename Value>
void exchange_values(Range& range, Map map, std::vector<Value>& values)
{
  std::size_t i = 0;
  const auto exchange = [&](auto it) {
    const Value old = get(map, *it);
    put(map, *it, values[i]);
    values[i] = old;
  };
  try {
    for (auto it = range.begin(); it != range.end(); ++it, ++i)
      exchange(it);
  }
  catch (...) {
    const std::size_t written = i;
    auto it = range.begin();
    for (i = 0; i < written; ++it, ++i)
      exchange(it);
    throw;
  }
}

/// Calls functions that exchange values, one after the other. If one throws, those before it are
/// called once more, which takes back what they did.
template <typename Exchange>
void write_all(const Exchange& last)
{
  last();
}
template <typename Exchange, typename... Rest>
void write_all(const Exchange& first, const Rest&... rest)
{
  first();
  try {
    write_all(rest...);
  }
  catch (...) {
    first();
    throw;
  }
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_BALANCED_FLOW_INTERNAL_COPY_OUT_H
