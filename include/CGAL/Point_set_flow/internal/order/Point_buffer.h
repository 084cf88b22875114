// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_ORDER_POINT_BUFFER_H
#define CGAL_POINT_SET_FLOW_INTERNAL_ORDER_POINT_BUFFER_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/Core_kernel.h>
#include <CGAL/Point_set_flow/internal/order/Given_noise.h>
#include <CGAL/Point_set_flow/internal/order/Spatial_order.h>
#include <CGAL/Point_set_flow/internal/order/merge_layers.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// The private copy that the flow works on: the distinct points of the input, in an order that
/// follows space and does not depend on the order of the input.
///
/// Exact duplicates are merged, since they would make nearest neighbors meaningless and searching
/// quadratic; afterwards they move as one.
class Point_buffer {
public:
  Array<Point_3> reference;           ///< \f$I\f$
  Array<Point_3> start;               ///< \f$\chi\f$; empty if it is the reference
  std::vector<char> constrained;      ///< empty if no point is
  Given_noise noise;                  ///< of duplicates the mean
  Array<Vector_3> sides;              ///< the given ones, null where not known; empty if none is
  Array<std::uint32_t> scans;         ///< their numbers; empty if not given
  std::vector<std::uint32_t> site_of; ///< for each input point, where it is above

  /// \param input at most \f$2^{32} - 1\f$ reference points in the order of the caller
  /// \param from where the flow starts, Eq. (7b); empty to start at the reference
  /// \param fixed which points must not move; empty if all may
  /// \param given the noise that the caller gives
  template <typename ConcurrencyTag>
  Point_buffer(const Array<Point_3>& input, const Array<Point_3>& from,
               const std::vector<char>& fixed, const Given_noise& given,
               Loops<ConcurrencyTag>& loops)
      : site_of(input.size())
  {
    const Spatial_order<ConcurrencyTag> order(input, from, loops);
    reference.resize(input.size());
    start.resize(from.size());
    const auto gather = [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        reference[i] = input[order[i]];
        if (!from.empty())
          start[i] = from[order[i]];
      }
    };
    loops.for_each_chunk(input.size(), gather);
    merge_duplicates(order);
    merge_noise(order, given);
    loops.ask();
    if (!fixed.empty())
      constrain(fixed);
  }

  /// Takes what the caller knows of layers.
  /// \param given_sides, given_scans in the order of the caller; empty if not given
  void add_layers(const Array<Vector_3>& given_sides, const Array<std::uint32_t>& given_scans)
  {
    sides = merged_sides(given_sides, site_of, size());
    scans = merged_scans(given_scans, site_of, size());
  }

  std::size_t size() const { return reference.size(); }

private:
  /// \param order that of the points now
  template <typename Order>
  void merge_duplicates(const Order& order)
  {
    std::size_t count = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
      if (i == 0 || reference[i] != reference[count - 1] ||
          (!start.empty() && start[i] != start[count - 1])) {
        reference[count] = reference[i];
        if (!start.empty())
          start[count] = start[i];
        ++count;
      }
      site_of[order[i]] = static_cast<std::uint32_t>(count - 1);
    }
    reference.resize(count);
    start.resize(start.empty() ? 0 : count);
  }

  /// \pre duplicates are merged
  template <typename Order>
  void merge_noise(const Order& order, const Given_noise& given)
  {
    noise.of_all = given.of_all;
    if (given.of_each.empty())
      return;
    noise.of_each.reserve(size());
    std::vector<double> of_site;
    for (std::size_t i = 0; i < order.size(); ++i) {
      of_site.push_back(given.of_each[order[i]]);
      if (i + 1 == order.size() || site_of[order[i + 1]] != site_of[order[i]]) {
        noise.of_each.push_back(mean_noise(of_site));
        of_site.clear();
      }
    }
  }

  void constrain(const std::vector<char>& fixed)
  {
    constrained.assign(size(), 0);
    for (std::size_t i = 0; i < fixed.size(); ++i)
      if (fixed[i])
        constrained[site_of[i]] = 1;
    for (std::size_t site = 0; site < start.size(); ++site)
      if (constrained[site])
        start[site] = reference[site]; // also if the others start elsewhere
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_ORDER_POINT_BUFFER_H
