// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_BENCHMARK_SPEED_METHODS_H
#define POINT_SET_FLOW_BENCHMARK_SPEED_METHODS_H

#include "measure/Numbered_points.h"

#include <CGAL/Point_set_processing_3/internal/Neighbor_query.h>
#include <CGAL/balanced_flow_smooth_point_set.h>
#include <CGAL/bilateral_smooth_point_set.h>
#include <CGAL/for_each.h>
#include <CGAL/jet_smooth_point_set.h>

#ifdef POINT_SET_FLOW_HAS_NANOFLANN
#include <nanoflann.hpp>
#endif

#ifdef POINT_SET_FLOW_HAS_PCL
#include "smooth_by_pcl.h"
#endif

#include <map>
#include <thread>
#include <type_traits>
#include <vector>

namespace comparison {

/// Neighbors of all points, as many for each
typedef std::vector<std::uint32_t> Neighbor_lists;

constexpr unsigned int peer_size = 24, graph_size = 20;

template <typename Concurrency_tag>
void smooth_by_jets(Points& points)
{
  CGAL::jet_smooth_point_set<Concurrency_tag>(points, peer_size);
}

/// One pass, of points whose normals are known
template <typename Concurrency_tag>
void smooth_bilaterally(Points& points)
{
  typedef std::pair<Point_3, Vector_3> Pair;
  std::vector<Pair> pairs;
  pairs.reserve(points.size());
  for (const Point_3& p : points) {
    const Vector_3 outward = p - CGAL::ORIGIN;
    pairs.emplace_back(p, outward / std::sqrt(outward.squared_length()));
  }
  CGAL::bilateral_smooth_point_set<Concurrency_tag>(
      pairs, peer_size,
      CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Pair>())
          .normal_map(CGAL::Second_of_pair_property_map<Pair>()));
}

/// The same with the normals that it needs
template <typename Concurrency_tag>
void smooth_bilaterally_with_normals(Points& points)
{
  Numbered_points numbered = with_normals<Concurrency_tag>(points, true);
  CGAL::bilateral_smooth_point_set<Concurrency_tag>(numbered, peer_size, numbered_point_maps());
}

#ifdef POINT_SET_FLOW_HAS_PCL
/// With a radius that holds as many neighbors as the others have, on a surface of radius 1
template <typename Concurrency_tag>
void smooth_by_moving_least_squares(Points& points)
{
  const bool is_parallel = !std::is_same<Concurrency_tag, CGAL::Sequential_tag>::value;
  smooth_by_pcl(points, 2. * std::sqrt(double(peer_size) / double(points.size())),
                is_parallel ? std::thread::hardware_concurrency() : 1);
}
#endif

template <typename Concurrency_tag>
void smooth_by_balanced_flow(Points& points)
{
  CGAL::balanced_flow_smooth_point_set<Concurrency_tag>(points);
}

template <typename Concurrency_tag>
void smooth_without_learned(Points& points)
{
  CGAL::balanced_flow_smooth_point_set<Concurrency_tag>(
      points, CGAL::parameters::curvature(CGAL::Point_set_flow::Tangent_plane_curvature()));
}

template <typename Concurrency_tag>
void smooth_with_given_k(Points& points)
{
  CGAL::balanced_flow_smooth_point_set<Concurrency_tag>(points, peer_size);
}

template <typename Concurrency_tag>
void find_neighbors_by_cgal(Points& points)
{
  typedef CGAL::Point_set_processing_3::internal::Neighbor_query<
      CGAL::Kernel_traits<Point_3>::Kernel, Points&, CGAL::Identity_property_map<Point_3>>
      Query;
  const Query query(points, CGAL::Identity_property_map<Point_3>());
  constexpr std::size_t size = graph_size + 1; // each point is its own neighbor, too
  std::vector<Points::iterator> lists(points.size() * size);
  CGAL::for_each<Concurrency_tag>(points, [&](const Point_3& p) {
    query.get_iterators(p, graph_size, 0., lists.begin() + (&p - points.data()) * size);
    return true;
  });
}

template <typename Concurrency_tag>
void find_neighbors(Points& points)
{
  using namespace CGAL::Point_set_flow::internal;
  Loops<Concurrency_tag> loops(nullptr, 1.);
  const Array<Point_3> copy(points.begin(), points.end());
  const Point_buffer buffer(copy, {}, {}, {}, loops);
  const Neighbor_tree tree(buffer.reference, loops);
  const Neighbor_graph graph(tree, {graph_size, 0.}, loops);
}

#ifdef POINT_SET_FLOW_HAS_NANOFLANN
struct Nanoflann_points {
  const Points& points;
  std::size_t kdtree_get_point_count() const { return points.size(); }
  double kdtree_get_pt(std::size_t i, std::size_t d) const { return points[i][int(d)]; }
  template <typename Box>
  bool kdtree_get_bbox(Box&) const
  {
    return false;
  }
};

template <typename Concurrency_tag>
void find_neighbors_by_nanoflann(Points& points)
{
  typedef nanoflann::KDTreeSingleIndexAdaptor<
      nanoflann::L2_Simple_Adaptor<double, Nanoflann_points>, Nanoflann_points, 3, std::uint32_t>
      Tree;
  const Nanoflann_points adaptor{points};
  Tree tree(3, adaptor, nanoflann::KDTreeSingleIndexAdaptorParams(10));
  tree.buildIndex();
  Neighbor_lists lists(points.size() * (graph_size + 1));
  CGAL::Point_set_flow::internal::Loops<Concurrency_tag> loops(nullptr, 1.);
  loops.for_each_chunk(points.size(), [&](std::size_t begin, std::size_t end) {
    std::vector<double> distances(graph_size + 1);
    for (std::size_t i = begin; i < end; ++i) {
      const double query[3] = {points[i].x(), points[i].y(), points[i].z()};
      tree.knnSearch(query, graph_size + 1, lists.data() + i * (graph_size + 1), distances.data());
    }
  });
}
#endif

typedef void (*Speed_method)(Points&);

template <typename Concurrency_tag>
std::map<std::string, Speed_method> speed_methods()
{
  return {
      {"jet", smooth_by_jets<Concurrency_tag>},
      {"bilateral", smooth_bilaterally<Concurrency_tag>},
      {"bilateral with normals", smooth_bilaterally_with_normals<Concurrency_tag>},
#ifdef POINT_SET_FLOW_HAS_PCL
      {"PCL MLS", smooth_by_moving_least_squares<Concurrency_tag>},
#endif
      {"ours", smooth_by_balanced_flow<Concurrency_tag>},
      {"ours, not learned", smooth_without_learned<Concurrency_tag>},
      {"ours, k=24", smooth_with_given_k<Concurrency_tag>},
      {"Neighbor_query", find_neighbors_by_cgal<Concurrency_tag>},
#ifdef POINT_SET_FLOW_HAS_NANOFLANN
      {"nanoflann", find_neighbors_by_nanoflann<Concurrency_tag>},
#endif
      {"our graph", find_neighbors<Concurrency_tag>},
  };
}

} // namespace comparison

#endif // POINT_SET_FLOW_BENCHMARK_SPEED_METHODS_H
