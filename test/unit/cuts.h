// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_TEST_CUTS_H
#define CGAL_POINT_SET_FLOW_TEST_CUTS_H

#include "stage_clouds.h"

#include <CGAL/Point_set_flow/internal/noise/choose_samples.h>
#include <CGAL/Point_set_flow/internal/order/Point_buffer.h>

#include <numeric>
#include <random>
#include <set>

// Parts of a point set with what they need of the others
namespace stages {

BOOST_AUTO_TEST_CASE(a_set_of_sites_knows_their_places)
{
  std::mt19937 random(5);
  for (const std::size_t n : {std::size_t(1), std::size_t(64), std::size_t(1000)}) {
    internal::Site_set sites(n);
    std::set<std::uint32_t> expected;
    for (std::size_t i = 0; i < n / 2 + 1; ++i) {
      const auto site = static_cast<std::uint32_t>(random() % n);
      BOOST_TEST(sites.insert(site) == expected.insert(site).second);
    }
    BOOST_TEST(sites.finish() == std::vector<std::uint32_t>(expected.begin(), expected.end()),
               boost::test_tools::per_element());
    for (std::uint32_t i = 0; i < n; ++i) {
      BOOST_TEST(sites.contains(i) == (expected.count(i) != 0));
      BOOST_TEST(sites.place(i) ==
                 std::uint32_t(std::distance(expected.begin(), expected.lower_bound(i))));
    }
  }
}

BOOST_AUTO_TEST_CASE(a_cut_has_the_neighbors_of_all_rings_but_the_last)
{
  const Points points = points_of_all_kinds();
  Loops loops(nullptr, 1.);
  const internal::Neighbor_tree tree(points, loops);
  const internal::Search_options search = {6};
  const internal::Neighbor_graph all(tree, search, loops);
  const std::vector<std::uint32_t> interior = {40, 41, 42, 700};
  const internal::Cut_graph cut = internal::cut_graph(tree, search, interior, 2, loops);
  BOOST_TEST(std::is_sorted(cut.sites.begin(), cut.sites.end()));
  const auto require_same = [&](std::size_t place) {
    const auto near = cut.graph.neighbors(place), expected = all.neighbors(cut.sites[place]);
    BOOST_REQUIRE(near.size() == expected.size());
    BOOST_TEST(cut.graph.radius(place) == all.radius(cut.sites[place]));
    for (std::size_t j = 0; j < near.size(); ++j)
      BOOST_TEST(cut.sites[near[j]] == expected[j]);
  };
  BOOST_REQUIRE(cut.interior.size() == interior.size());
  for (std::size_t i = 0; i < interior.size(); ++i) {
    BOOST_TEST(cut.sites[cut.interior[i]] == interior[i]);
    require_same(cut.interior[i]);
    const auto near = cut.graph.neighbors(cut.interior[i]);
    for (std::size_t j = 0; j < near.size(); ++j)
      require_same(near[j]);
  }
}

BOOST_AUTO_TEST_CASE(samples_do_not_depend_on_blocks)
{
  Points cloud = array(shapes::sphere(3000, 1.));
  cloud.resize(2000); // with a border
  cloud.emplace_back(1e3, 0., 0.);
  Loops loops(nullptr, 1.);
  const internal::Point_buffer buffer(cloud, {}, {}, {}, loops);
  const internal::Neighbor_tree tree(buffer.reference, loops);
  const internal::Neighbor_graph graph(tree, {internal::choice_size}, loops);
  const internal::Clearance whole;
  internal::Certainty certainty(whole);
  const auto expected = internal::choose_samples(buffer.reference, graph, certainty, loops);
  BOOST_TEST(expected.size() > 50u);
  for (const std::size_t block_size : {std::size_t(100), std::size_t(999), std::size_t(5000)})
    BOOST_TEST(internal::choose_samples_in_blocks(tree, block_size, loops) == expected,
               boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_chunk_holds_any_number_of_neighbors)
{
  internal::Neighbor_chunk chunk;
  const std::size_t sizes[] = {3, 65534, 65535, 70000};
  for (std::size_t i = 0; i < 4; ++i) // every second point has no neighbors
    chunk.add(2 * i, 1000, sizes[i], [](std::size_t j) { return std::uint32_t(1001 + j % 3); });
  chunk.skip(8);
  for (const bool is_shrunk : {false, true})
    for (std::size_t i = 0; i < 4; ++i) {
      BOOST_TEST(chunk.neighbors(2 * i + 1, 1000).size() == 0u);
      if (is_shrunk)
        chunk.shrink(2 * i, 2);
      const auto near = chunk.neighbors(2 * i, 1000);
      BOOST_REQUIRE(near.size() == (is_shrunk ? 2 : sizes[i]));
      for (std::size_t j = 0; j < near.size(); ++j)
        BOOST_REQUIRE(near[j] == 1001 + j % 3);
    }
}

BOOST_AUTO_TEST_CASE(sides_are_accurate_to_half_a_degree)
{
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  BOOST_TEST(!Side_3().is_known());
  BOOST_TEST(!Side_3(Vector_3(0., 0., 0.)).is_known());
  for (int i = 0; i < 1000; ++i) {
    const Vector_3 v(normal(random), normal(random), std::pow(normal(random), 3));
    const Side_3 side(1e-3 * v), opposite(-v);
    BOOST_REQUIRE(side.is_known());
    BOOST_REQUIRE(opposite.vector() == -Side_3(v).vector());
    const double cosine =
        side.vector() * v / std::sqrt(side.vector().squared_length() * v.squared_length());
    BOOST_REQUIRE(cosine > std::cos(.5 * CGAL_PI / 180.));
  }
}

} // namespace stages

#endif // CGAL_POINT_SET_FLOW_TEST_CUTS_H
