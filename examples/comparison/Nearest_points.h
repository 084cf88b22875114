// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_COMPARISON_NEAREST_POINTS_H
#define BALANCED_FLOW_COMPARISON_NEAREST_POINTS_H

#include "Surface.h"

#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/property_map.h>

#include <boost/iterator/counting_iterator.hpp>

/// The nearest points of a set, by their numbers.
class Nearest_points {
  typedef CGAL::Pointer_property_map<Point_3>::const_type Map;
  typedef CGAL::Search_traits_adapter<std::size_t, Map, CGAL::Search_traits_3<Kernel>> Traits;
  typedef CGAL::Orthogonal_k_neighbor_search<Traits> Search;

  Map m_map;
  Search::Distance m_distance;
  Search::Tree m_tree;

public:
  explicit Nearest_points(const Points& points)
      : m_map(CGAL::make_property_map(points)), m_distance(m_map),
        m_tree(boost::counting_iterator<std::size_t>(0),
               boost::counting_iterator<std::size_t>(points.size()), Search::Splitter(),
               Traits(m_map))
  {
    m_tree.build();
  }
  Nearest_points(const Nearest_points&) = delete;
  Nearest_points& operator=(const Nearest_points&) = delete;

  /// Pairs of number and squared distance, the nearest first
  std::vector<std::pair<std::size_t, double>> operator()(const Point_3& p, unsigned int k) const
  {
    const Search search(m_tree, p, k, 0., true, m_distance);
    return {search.begin(), search.end()};
  }
  std::pair<std::size_t, double> operator()(const Point_3& p) const
  {
    return *Search(m_tree, p, 1, 0., true, m_distance).begin();
  }
};

#endif // BALANCED_FLOW_COMPARISON_NEAREST_POINTS_H
