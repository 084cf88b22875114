// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_NEIGHBOR_TREE_H
#define CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_NEIGHBOR_TREE_H

#include <CGAL/Point_set_flow/Core_kernel.h>
#include <CGAL/Point_set_flow/internal/parallel/Array.h>
#include <CGAL/Point_set_flow/internal/parallel/Progress.h>
#include <CGAL/Kd_tree.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/Splitters.h>
#include <CGAL/property_map.h>

#include <boost/iterator/counting_iterator.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <limits>
#include <thread>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// CGAL's kd-tree over an array of points, with a search of its own: it keeps its result in one
/// sorted buffer of the caller and starts from what the query before it found. That makes it
/// several times faster than `Orthogonal_k_neighbor_search` for points in spatial order.
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
        progress.advance(0.);
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
      const std::size_t much = 1 << 14; // to sort
      if (c0.size() > much && std::this_thread::get_id() == m_building->caller)
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

  const Array<Point_3>& m_points;
  Building m_building;
  Tree m_tree;

  typedef Tree::Node_const_handle Node;
  typedef Tree::Leaf_node_const_handle Leaf;
  typedef Tree::Internal_node_const_handle Internal;

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
  struct Neighbor {
    double squared_distance;
    std::uint32_t index;
    bool operator<(const Neighbor& other) const // equal distances: the order of the points decides
    {
      return squared_distance < other.squared_distance ||
             (squared_distance == other.squared_distance && index < other.index);
    }
  };

  template <typename ConcurrencyTag>
  Neighbor_tree(ConcurrencyTag, const Array<Point_3>& points, Progress& progress)
      : m_points(points), m_building{progress, points},
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

  /// Calls `visit(begin, end)` for the indices in each leaf that may have points within a distance of
  /// a box, always in the same order, until it returns `false`.
  /// \return whether it never did
  template <typename Visit>
  bool visit_leaves(const std::array<double, 3>& low, const std::array<double, 3>& high,
                    double squared_distance, const Visit& visit) const
  {
    return m_points.empty() ||
           visit_leaves(m_tree.root(), low, high, {{0., 0., 0.}}, squared_distance, visit);
  }

  /// One thread's search for the `k` nearest neighbors of points of the array.
  class Query {
    const Neighbor_tree& m_owner;
    std::size_t m_k;
    double m_largest; // no neighbor is farther than this squared distance
    double m_bound = 0.;
    static constexpr std::size_t nowhere = std::size_t(-1);
    std::size_t m_center = 0; // is not its own neighbor
    Point_3 m_before = Point_3(0., 0., 0.);
    std::array<double, 3> m_query = {{0., 0., 0.}};
    std::vector<Neighbor> m_found;

  public:
    /// \param radius the distance beyond which there are no neighbors, 0 for no limit
    Query(const Neighbor_tree& tree, std::size_t k, double radius = 0.)
        : m_owner(tree), m_k(k),
          m_largest(radius > 0. ? radius * radius : (std::numeric_limits<double>::infinity)())
    {
      m_found.reserve(k + 1);
    }

    /// The nearest neighbors of point `i`, without itself, nearest first.
    const std::vector<Neighbor>& operator()(std::size_t i)
    {
      if (m_center == nowhere)
        m_found.clear(); // point i may be among them
      m_center = i;
      return search(m_owner.m_points[i]);
    }

    /// The nearest points of any place, nearest first.
    const std::vector<Neighbor>& operator()(const Point_3& place)
    {
      m_center = nowhere;
      return search(place);
    }

  private:
    const std::vector<Neighbor>& search(const Point_3& p)
    {
      m_bound = m_largest;
      if (m_found.size() == m_k) {
        // the ball of the previous answer holds k points other than this one (its own center
        // instead, if this one was among them): so does, around this point, a ball larger by the
        // distance of the two
        const double moved = std::sqrt(squared_distance(p, m_before));
        const double radius = std::sqrt(m_found.back().squared_distance) + moved;
        m_bound = (std::min)(m_bound, radius * radius * (1. + 1e-12) +
                                          (std::numeric_limits<double>::min)()); // rounding
      }
      m_found.clear();
      m_before = p;
      m_query = {{p.x(), p.y(), p.z()}};
      visit(m_owner.m_tree.root(), {{0., 0., 0.}});
      return m_found;
    }

    /// \param offset the distance from the query to the box of the node in each coordinate
    void visit(Node node, const std::array<double, 3>& offset)
    {
      if (node->is_leaf()) {
        const Leaf leaf = static_cast<Leaf>(node);
        for (auto it = leaf->begin(); it != leaf->end(); ++it)
          offer(*it);
        return;
      }
      const Internal inner = static_cast<Internal>(node);
      const std::size_t d = std::size_t(inner->cutting_dimension());
      const double below = m_query[d] - inner->lower_high_value();
      const double above = inner->upper_low_value() - m_query[d];
      const bool lower_first = above >= below;
      visit(lower_first ? inner->lower() : inner->upper(), offset);

      std::array<double, 3> far = offset;
      far[d] = (std::max)(far[d], lower_first ? above : below);
      // the sum in the order of squared_distance(): rounding can not make a box farther than the
      // points in it
      if (far[0] * far[0] + far[1] * far[1] + far[2] * far[2] <= m_bound)
        visit(lower_first ? inner->upper() : inner->lower(), far);
    }

    void offer(std::size_t i)
    {
      const Point_3& p = m_owner.m_points[i];
      const double x = m_query[0] - p.x(), y = m_query[1] - p.y(), z = m_query[2] - p.z();
      const Neighbor candidate = {x * x + y * y + z * z, static_cast<std::uint32_t>(i)};
      if (!(candidate.squared_distance <= m_bound) || i == m_center)
        return;
      if (m_found.size() == m_k) {
        if (!(candidate < m_found.back()))
          return;
        m_found.pop_back();
      }
      m_found.insert(std::upper_bound(m_found.begin(), m_found.end(), candidate), candidate);
      if (m_found.size() == m_k)
        m_bound = m_found.back().squared_distance;
    }
  };
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_NEIGHBOR_TREE_H
