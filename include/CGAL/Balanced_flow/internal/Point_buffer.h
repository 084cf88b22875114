// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BALANCED_FLOW_INTERNAL_POINT_BUFFER_H
#define CGAL_BALANCED_FLOW_INTERNAL_POINT_BUFFER_H

#include <CGAL/Balanced_flow/Vector_types.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/parallel_sort.h>
#endif

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <type_traits>
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
  std::vector<Point_3> reference;     ///< \f$I\f$
  std::vector<Point_3> start;         ///< \f$\chi\f$; empty if it is the reference
  std::vector<char> constrained;      ///< empty if no point is
  std::vector<std::uint32_t> site_of; ///< for each input point, where it is above

  /// \param concurrency `Sequential_tag` or `Parallel_tag`
  /// \param input the reference points in the order of the caller
  /// \param from where the flow starts, Eq. (7b); empty to start at the reference
  /// \param fixed which points must not move; empty if all may
  template <typename ConcurrencyTag>
  Point_buffer(ConcurrencyTag concurrency, const std::vector<Point_3>& input,
               const std::vector<Point_3>& from, const std::vector<char>& fixed)
      : site_of(input.size())
  {
    if (input.size() > (std::numeric_limits<std::uint32_t>::max)())
      throw std::length_error("CGAL::balanced_flow_smooth_point_set: more than 2^32 - 1 points");
    std::vector<Entry> entries = sorted_entries(concurrency, input, from);

    // one entry for each site, with the place among the sorted ones for a number
    std::vector<Point_3> sorted_start;
    std::size_t count = 0;
    for (const Entry& entry : entries) {
      const std::uint32_t i = entry.index;
      if (count == 0 || entry.point != entries[count - 1].point ||
          (!from.empty() && from[i] != sorted_start.back())) {
        entries[count] = {entry.point, static_cast<std::uint32_t>(count)};
        ++count;
        if (!from.empty())
          sorted_start.push_back(from[i]);
      }
      site_of[i] = static_cast<std::uint32_t>(count - 1); // its place follows below
    }
    entries.resize(count);
    // a few points in one place of the order are near enough to each other
    typedef Hilbert_sort_3<Sort_traits, Hilbert_sort_median_policy, ConcurrencyTag> Hilbert_sort;
    Hilbert_sort(Sort_traits(), 4)(entries.begin(), entries.end());

    std::vector<std::uint32_t> place(count);
    reference.reserve(count);
    for (const Entry& entry : entries) {
      place[entry.index] = static_cast<std::uint32_t>(reference.size());
      reference.push_back(entry.point);
      if (!from.empty())
        start.push_back(sorted_start[entry.index]);
    }
    for (std::uint32_t& site : site_of)
      site = place[site];

    if (!fixed.empty()) {
      constrained.assign(count, 0);
      for (std::size_t i = 0; i < fixed.size(); ++i)
        if (fixed[i])
          constrained[site_of[i]] = 1;
      for (std::size_t site = 0; site < start.size(); ++site)
        if (constrained[site])
          start[site] = reference[site]; // also if the others start elsewhere
    }
  }

  const Point_3& start_of(std::size_t site) const
  {
    return start.empty() ? reference[site] : start[site];
  }

  std::size_t size() const { return reference.size(); }

private:
  struct Entry {
    Point_3 point;
    std::uint32_t index;
  };

  /// What the Hilbert sort of \cgal asks for
  struct Sort_traits {
    typedef Entry Point_3;
    template <int d>
    struct Less {
      bool operator()(const Entry& a, const Entry& b) const { return a.point[d] < b.point[d]; }
    };
    typedef Less<0> Less_x_3;
    typedef Less<1> Less_y_3;
    typedef Less<2> Less_z_3;
    Less_x_3 less_x_3_object() const { return Less_x_3(); }
    Less_y_3 less_y_3_object() const { return Less_y_3(); }
    Less_z_3 less_z_3_object() const { return Less_z_3(); }
  };

  /// Sorts by coordinates, which brings duplicates together and forgets the order of the input.
  template <typename ConcurrencyTag>
  static std::vector<Entry> sorted_entries(ConcurrencyTag, const std::vector<Point_3>& input,
                                           const std::vector<Point_3>& from)
  {
    std::vector<Entry> entries;
    entries.reserve(input.size());
    for (const Point_3& p : input)
      entries.push_back({p, static_cast<std::uint32_t>(entries.size())});
    const auto less = [&](const Entry& a, const Entry& b) {
      const Point_3 &p = a.point, &q = b.point;
      if (p.x() != q.x())
        return p.x() < q.x();
      if (p.y() != q.y())
        return p.y() < q.y();
      if (p.z() != q.z() || from.empty())
        return p.z() < q.z();
      return from[a.index] < from[b.index];
    };
#ifdef CGAL_LINKED_WITH_TBB
    if constexpr (std::is_convertible<ConcurrencyTag, Parallel_tag>::value)
      tbb::parallel_sort(entries.begin(), entries.end(), less);
    else
#endif
      std::sort(entries.begin(), entries.end(), less);
    return entries;
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_BALANCED_FLOW_INTERNAL_POINT_BUFFER_H
