// SPDX-License-Identifier: GPL-3.0-or-later
#include "Nearest_points.h"

#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/property_map.h>

#include <boost/iterator/counting_iterator.hpp>

namespace comparison {

struct Nearest_points::Search {
  typedef CGAL::Pointer_property_map<Point_3>::const_type Map;
  typedef CGAL::Search_traits_adapter<std::size_t, Map, CGAL::Search_traits_3<Kernel>> Traits;
  typedef CGAL::Orthogonal_k_neighbor_search<Traits> Neighbors;

  Map map;
  Neighbors::Distance distance;
  Neighbors::Tree tree;

  explicit Search(const Points& points)
      : map(CGAL::make_property_map(points)), distance(map),
        tree(boost::counting_iterator<std::size_t>(0),
             boost::counting_iterator<std::size_t>(points.size()), Neighbors::Splitter(),
             Traits(map))
  {
    tree.build();
  }

  Neighbors operator()(const Point_3& p, unsigned int k) const
  {
    return Neighbors(tree, p, k, 0., true, distance);
  }
};

Nearest_points::Nearest_points(const Points& points)
    : m_search(std::make_unique<const Search>(points))
{}

Nearest_points::~Nearest_points() = default;

std::vector<std::pair<std::size_t, double>> Nearest_points::operator()(const Point_3& p,
                                                                       unsigned int k) const
{
  const Search::Neighbors found = (*m_search)(p, k);
  return {found.begin(), found.end()};
}

std::pair<std::size_t, double> Nearest_points::operator()(const Point_3& p) const
{
  return *(*m_search)(p, 1).begin();
}

} // namespace comparison
