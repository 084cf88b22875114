// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_NEIGHBOR_TREE_H
#define CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_NEIGHBOR_TREE_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/Core_kernel.h>
#include <CGAL/Point_set_flow/internal/parallel/Array.h>
#include <CGAL/Point_set_flow/internal/parallel/Loops.h>
#include <CGAL/Kd_tree.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/Splitters.h>
#include <CGAL/property_map.h>

#include <boost/iterator/counting_iterator.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <exception>
#include <limits>
#include <thread>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// CGAL's kd-tree over an array of points. `Neighbor_query` and `Group_search` search it.
class Neighbor_tree {
  typedef Pointer_property_map<Point_3>::const_type Point_map;
  typedef Search_traits_adapter<std::size_t, Point_map, Search_traits_3<Core_kernel>> Traits;

  /// What a callback said while \cgal built the tree. It must not throw there: the tree would lose
  /// the memory of its bounding box.
  struct Building {
    Progress& progress;
    const Array<Point_3>& points;
    const std::thread::id caller = std::this_thread::get_id();
    std::exception_ptr error = nullptr;
    std::atomic<bool> stopped{false};

    void ask()
    {
      if (stopped)
        return;
      try {
        progress.ask();
      }
      catch (...) {
        error = std::current_exception();
        stopped = true;
      }
    }
  };

  /// \cgal builds the tree in one go; but it calls this for each node, which asks the callback. If
  /// that says no, all nodes that are not split yet become leaves.
  ///
  /// \cgal's splitters take a single point off where most share the least coordinate, say a plane with
  /// one point far from it: that would be quadratic. Here the plane is taken off in one.
  class Splitter : public Median_of_max_spread<Traits> {
    typedef Median_of_max_spread<Traits> Base;
    Building* m_building;

  public:
    explicit Splitter(Building* building) : Base(16), m_building(building) {}

    unsigned int bucket_size() const
    {
      return m_building->stopped ? (std::numeric_limits<unsigned int>::max)() : Base::bucket_size();
    }

    template <typename Separator, typename Container>
    void operator()(Separator& separator, Container& c0, Container& c1) const
    {
      const std::size_t worth_asking = 1 << 14;
      if (c0.size() > worth_asking && std::this_thread::get_id() == m_building->caller)
        m_building->ask();
      const int d = c0.max_tight_span_coord();
      const double least = c0.tight_bounding_box().min_coord(d);
      double cut = c0.median(d); // what is less goes to one side
      if (!(cut > least)) {
        cut = c0.tight_bounding_box().max_coord(d);
        for (const std::size_t* i : c0) {
          const double c = m_building->points[*i][d];
          if (c > least)
            cut = (std::min)(cut, c);
        }
      }
      separator = Separator(d, cut);
      c0.split(c1, separator, true);
    }
  };
  typedef Kd_tree<Traits, Splitter, Tag_true> Tree;

public:
  typedef Tree::Node_const_handle Node;
  typedef Tree::Leaf_node_const_handle Leaf;
  typedef Tree::Internal_node_const_handle Internal;

private:
  const Array<Point_3>& m_points;
  Building m_building;
  Tree m_tree;

  /// \param offset the distance from the box to that of the node in each coordinate
  template <typename Visit>
  static bool visit_leaves(Node node, const std::array<double, 3>& low,
                           const std::array<double, 3>& high, const std::array<double, 3>& offset,
                           double squared_distance, const Visit& visit)
  {
    if (node->is_leaf()) {
      const Leaf leaf = static_cast<Leaf>(node);
      return visit(&*leaf->begin(), &*leaf->begin() + leaf->size());
    }
    const Internal inner = static_cast<Internal>(node);
    const std::size_t d = std::size_t(inner->cutting_dimension());
    const auto visit_child = [&](Node child, double beyond) {
      std::array<double, 3> far = offset;
      far[d] = (std::max)(far[d], beyond);
      // rounding must not make a box farther than the points in it: in the order of the distances
      return !(far[0] * far[0] + far[1] * far[1] + far[2] * far[2] <= squared_distance) ||
             visit_leaves(child, low, high, far, squared_distance, visit);
    };
    return visit_child(inner->lower(), low[d] - inner->lower_high_value()) &&
           visit_child(inner->upper(), inner->upper_low_value() - high[d]);
  }

public:
  template <typename ConcurrencyTag>
  Neighbor_tree(const Array<Point_3>& points, Loops<ConcurrencyTag>& loops)
      : m_points(points), m_building{loops, points},
        m_tree(boost::counting_iterator<std::size_t>(0),
               boost::counting_iterator<std::size_t>(points.size()), Splitter(&m_building),
               Traits(Point_map(points.data())))
  {
    if (!points.empty())
      m_tree.build<ConcurrencyTag>();
    if (m_building.error)
      std::rethrow_exception(m_building.error);
  }

  Neighbor_tree(const Neighbor_tree&) = delete;
  Neighbor_tree& operator=(const Neighbor_tree&) = delete;

  const Array<Point_3>& points() const { return m_points; }
  /// \pre there are points
  Node root() const { return m_tree.root(); }

  /// Calls `visit(begin, end)` for the indices in each leaf that may have points within a distance of
  /// a box, always in the same order, until it returns `false`.
  /// \return whether it never did
  template <typename Visit>
  bool visit_leaves(const std::array<double, 3>& low, const std::array<double, 3>& high,
                    double squared_distance, const Visit& visit) const
  {
    return m_points.empty() ||
           visit_leaves(root(), low, high, {{0., 0., 0.}}, squared_distance, visit);
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_NEIGHBOR_TREE_H
