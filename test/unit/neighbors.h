// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_TEST_NEIGHBORS_H
#define CGAL_POINT_SET_FLOW_TEST_NEIGHBORS_H

#include "stage_clouds.h"

#include <CGAL/Point_set_flow/internal/neighbors/nearest_points.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>

// The search of neighbors, against all distances and against CGAL
namespace stages {

BOOST_AUTO_TEST_CASE(the_graph_has_the_nearest_neighbors)
{
  const Points points = points_of_all_kinds();
  Loops loops(nullptr, 1.);
  const internal::Neighbor_tree tree(points, loops);
  for (const double radius : {0., .4}) // without a limit, and with one
    for (const std::size_t k : {std::size_t(1), std::size_t(7), std::size_t(30), points.size()}) {
      internal::Neighbor_graph graph(tree, {k, radius, {}, nullptr}, loops);
      const auto check = [&](std::size_t i, std::size_t most) {
        auto expected = by_distance(points, i);
        expected.resize((std::min)(most, expected.size()));
        while (radius > 0. && !expected.empty() &&
               expected.back().squared_distance > radius * radius)
          expected.pop_back();
        BOOST_REQUIRE(graph.size(i) == expected.size());
        const double farthest = expected.empty() ? 0. : expected.back().squared_distance;
        BOOST_REQUIRE(graph.radius(i) == Compact_length(std::sqrt(farthest)).value());
        for (std::size_t j = 0; j < expected.size(); ++j)
          BOOST_REQUIRE(graph.neighbors(i)[j] == expected[j].index);
      };
      for (std::size_t i = 0; i < points.size(); i += 3)
        check(i, k);
      internal::Array<std::uint32_t> sizes(points.size());
      for (std::size_t i = 0; i < sizes.size(); ++i)
        sizes[i] = std::uint32_t(1 + i % 20);
      graph.shrink(points, sizes, loops);
      for (std::size_t i = 0; i < points.size(); i += 7)
        check(i, (std::min)(k, std::size_t(sizes[i])));
    }
}

BOOST_AUTO_TEST_CASE(a_graph_of_few_points_has_as_many_neighbors_as_wanted)
{
  Loops loops(nullptr, 1.);
  for (const std::size_t n : {10u, 33u, 91u, 300u}) {
    const Points points = array(shapes::sphere(n, 1.));
    const internal::Neighbor_tree tree(points, loops);
    for (const std::size_t k : {n / 4, n / 2, 2 * n / 3, n - 2}) {
      const internal::Neighbor_graph graph(tree, {k}, loops);
      for (std::size_t i = 0; i < n; ++i) {
        BOOST_REQUIRE(graph.size(i) == k);
        BOOST_REQUIRE(
            graph.radius(i) ==
            Compact_length(std::sqrt(by_distance(points, i)[k - 1].squared_distance)).value());
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(parts_of_the_points_have_numbers_of_neighbors_of_their_own)
{
  const Points points = points_of_all_kinds();
  Loops loops(nullptr, 1.);
  const internal::Neighbor_tree tree(points, loops);
  const internal::Array<std::uint32_t> part_of = three_parts(points.size(), 50);
  const std::vector<std::uint32_t> sizes = {5, 40, 1000000};
  const internal::Neighbor_graph graph(tree, {0, 0., sizes, &part_of}, loops);
  for (std::size_t part = 0; part < 3; ++part) {
    const internal::Neighbor_graph alike(tree, {sizes[part]}, loops);
    for (std::size_t i = 0; i < points.size(); ++i)
      if (part_of[i] == part) {
        require_same_neighborhood(graph, alike, i);
      }
  }
}

BOOST_AUTO_TEST_CASE(neighbors_are_the_nearest_ones)
{
  const Points points = points_of_all_kinds();
  typedef CGAL::Orthogonal_k_neighbor_search<CGAL::Search_traits_3<Core_kernel>> Search;
  Search::Tree cgal_tree(points.begin(), points.end());
  Loops loops(nullptr, 1.);
  const internal::Neighbor_tree tree(points, loops);
  for (const unsigned int k : {1u, 7u, 30u}) {
    internal::Neighbor_query query(tree, k);
    internal::Neighbor_query within(tree, k, .4), anywhere(tree, k);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto expected = by_distance(points, i);
      const auto found = query(i);
      BOOST_REQUIRE(found.size() == k);
      for (std::size_t j = 0; j < k; ++j)
        BOOST_REQUIRE(found[j].index == expected[j].index);

      Search search(cgal_tree, points[i], k + 1);
      double farthest = 0.;
      for (const auto& neighbor : search)
        farthest = (std::max)(farthest, neighbor.second);
      BOOST_REQUIRE(found.back().squared_distance == farthest);

      // the same place as a place, where the point itself is the nearest
      const auto& around = anywhere(points[i]);
      BOOST_REQUIRE(around.front().squared_distance == 0.);
      for (std::size_t j = 1; j < k; ++j)
        BOOST_REQUIRE(around[j].squared_distance == expected[j - 1].squared_distance);

      const auto near = within(i);
      const std::size_t in_ball =
          std::size_t(std::count_if(expected.begin(), expected.end(),
                                    [](const auto& n) { return n.squared_distance <= .4 * .4; }));
      BOOST_REQUIRE(near.size() == (std::min)(std::size_t(k), in_ball));
      for (std::size_t j = 0; j < near.size(); ++j)
        BOOST_REQUIRE(near[j].index == expected[j].index);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_graph_holds_neighbors_that_are_far_in_the_order_of_the_points)
{
  // two lines beside each other, one after the other in memory: the nearest point is on the other line
  Points points;
  const std::size_t n = 40000;
  for (const double y : {0., .5})
    for (std::size_t i = 0; i < n; ++i)
      points.emplace_back(double(i), y, 0.);
  Loops loops(nullptr, 1.);
  const internal::Neighbor_tree tree(points, loops);
  internal::Neighbor_graph graph(tree, {3}, loops);
  for (const std::size_t size : {std::size_t(3), std::size_t(1)}) {
    for (std::size_t i = 1; i + 1 < n; i += 100) {
      BOOST_REQUIRE(graph.size(i) == size);
      BOOST_REQUIRE(graph.neighbors(i)[0] == n + i);
      BOOST_REQUIRE(graph.neighbors(n + i)[0] == i);
      if (size == 3)
        BOOST_REQUIRE(graph.neighbors(i)[1] == i - 1);
    }
    graph.shrink(points, internal::Array<std::uint32_t>(points.size(), 1), loops);
  }
}

BOOST_AUTO_TEST_CASE(a_graph_adapts_to_other_numbers_of_neighbors)
{
  const Points points = points_of_all_kinds();
  Loops loops(nullptr, 1.);
  const internal::Neighbor_tree tree(points, loops);
  const internal::Array<std::uint32_t> part_of = three_parts(points.size(), 5);
  for (const std::uint32_t most :
       {50u, 20u}) { // for which a search is needed, and for which none is
    const internal::Search_options search = {0, 0., {7, 20, most}, &part_of};
    const internal::Neighbor_graph expected(tree, search, loops);
    internal::Neighbor_graph graph(tree, {20}, loops);
    graph.adapt(tree, search, loops);
    for (std::size_t i = 0; i < points.size(); ++i)
      require_same_neighborhood(graph, expected, i);
  }
}

BOOST_AUTO_TEST_CASE(each_place_has_its_nearest_point)
{
  const Points points = points_of_all_kinds();
  Loops loops(nullptr, 1.);
  for (const std::size_t share : {std::size_t(1), std::size_t(20), points.size()}) {
    Points some;
    for (std::size_t i = 0; i < points.size(); i += share)
      some.push_back(points[i]);
    const internal::Neighbor_tree tree(some, loops);
    const auto nearest = internal::nearest_points(tree, points, loops);
    for (std::size_t i = 0; i < points.size(); ++i) {
      std::size_t expected = 0;
      for (std::size_t j = 1; j < some.size(); ++j)
        if (CGAL::squared_distance(points[i], some[j]) <
            CGAL::squared_distance(points[i], some[expected]))
          expected = j;
      BOOST_REQUIRE(nearest[i] == expected);
    }
  }
}

} // namespace stages

#endif // CGAL_POINT_SET_FLOW_TEST_NEIGHBORS_H
