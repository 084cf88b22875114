// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BALANCED_FLOW_INTERNAL_POINT_BUFFER_H
#define CGAL_BALANCED_FLOW_INTERNAL_POINT_BUFFER_H

#include <CGAL/Balanced_flow/Vector_types.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/parallel_sort.h>
#endif

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// The private copy that the flow works on: the distinct points of the input, in an order that
/// follows space and does not depend on the order of the input.
///
/// Exact duplicates are merged, since they would make nearest neighbours meaningless and searching
/// quadratic; afterwards they move as one.
class Point_buffer {
public:
  std::vector<Point_3> points;        ///< \f$u\f$
  std::vector<Point_3> reference;     ///< \f$I\f$
  std::vector<char> constrained;      ///< empty if no point is
  std::vector<std::uint32_t> site_of; ///< for each input point, where it is above

  /// \param concurrency `Sequential_tag` or `Parallel_tag`
  /// \param input the reference points in the order of the caller
  /// \param start where the flow starts, Eq. (7b); empty to start at the reference
  /// \param fixed which points must not move; empty if all may
  template <typename ConcurrencyTag>
  Point_buffer(ConcurrencyTag concurrency, const std::vector<Point_3>& input,
               const std::vector<Point_3>& start, const std::vector<char>& fixed)
      : site_of(input.size())
  {
    if (input.size() > (std::numeric_limits<std::uint32_t>::max)())
      throw std::length_error("CGAL::balanced_flow_smooth_point_set: more than 2^32 - 1 points");
    const std::vector<Point_3>& from = start.empty() ? input : start;

    const auto equal = [&](std::size_t a, std::size_t b) {
      return input[a] == input[b] && from[a] == from[b];
    };
    std::vector<std::uint32_t> sorted = sort(concurrency, input, from);
    std::vector<std::size_t> distinct; // one input point for each site
    for (const std::uint32_t i : sorted) {
      if (distinct.empty() || !equal(distinct.back(), i))
        distinct.push_back(i);
      site_of[i] = static_cast<std::uint32_t>(distinct.back()); // its place follows below
    }
    sorted = std::vector<std::uint32_t>();

    const auto point_map = CGAL::make_property_map(input);
    hilbert_sort<ConcurrencyTag>(
        distinct.begin(), distinct.end(),
        Spatial_sort_traits_adapter_3<Core_kernel, decltype(point_map)>(point_map));

    std::vector<std::uint32_t> place(input.size());
    for (std::size_t site = 0; site < distinct.size(); ++site) {
      place[distinct[site]] = static_cast<std::uint32_t>(site);
      points.push_back(from[distinct[site]]);
      reference.push_back(input[distinct[site]]);
    }
    for (std::uint32_t& site : site_of)
      site = place[site];

    if (!fixed.empty()) {
      constrained.assign(points.size(), 0);
      for (std::size_t i = 0; i < fixed.size(); ++i)
        if (fixed[i])
          constrained[site_of[i]] = 1;
      for (std::size_t site = 0; site < points.size(); ++site)
        if (constrained[site])
          points[site] = reference[site]; // also if the others start elsewhere
    }
  }

  std::size_t size() const { return points.size(); }

private:
  /// Sorts by coordinates, which brings duplicates together and forgets the order of the input.
  template <typename ConcurrencyTag>
  static std::vector<std::uint32_t> sort(ConcurrencyTag, const std::vector<Point_3>& input,
                                         const std::vector<Point_3>& from)
  {
    std::vector<std::uint32_t> order(input.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto less = [&](std::uint32_t a, std::uint32_t b) {
      return input[a] < input[b] || (input[a] == input[b] && from[a] < from[b]);
    };
#ifdef CGAL_LINKED_WITH_TBB
    if constexpr (std::is_convertible<ConcurrencyTag, Parallel_tag>::value)
      tbb::parallel_sort(order.begin(), order.end(), less);
    else
#endif
      std::sort(order.begin(), order.end(), less);
    return order;
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_BALANCED_FLOW_INTERNAL_POINT_BUFFER_H
