// SPDX-License-Identifier: GPL-3.0-or-later
// Balanced_flow_smoother as a model of the concept Smoother of CGAL's scale space reconstruction.
#define BOOST_TEST_MODULE scale_space_reconstruction
#include <boost/test/unit_test.hpp>

#include "shapes.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Scale_space_reconstruction_3/Advancing_front_mesher.h>
#include <CGAL/Scale_space_reconstruction_3/Balanced_flow_smoother.h>
#include <CGAL/Scale_space_surface_reconstruction_3.h>

#include <list>
#include <map>
#include <type_traits>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef std::vector<Kernel::Point_3> Points;
typedef CGAL::Scale_space_surface_reconstruction_3<Kernel> Reconstruction;
typedef CGAL::Scale_space_reconstruction_3::Advancing_front_mesher<Kernel> Mesher;
typedef CGAL::Scale_space_reconstruction_3::Balanced_flow_smoother<Kernel> Smoother;
typedef CGAL::Scale_space_reconstruction_3::Balanced_flow_smoother<Kernel, CGAL::Sequential_tag>
    Sequential_smoother;

namespace {

Points noisy_sphere()
{
  shapes::Points sphere = shapes::sphere(3000, 2.);
  shapes::add_noise(sphere, .03);
  Points points;
  for (const auto& p : sphere)
    points.emplace_back(p.x(), p.y(), p.z());
  return points;
}

template <typename... Arguments>
Points smoothed(Points points, const Arguments&... arguments)
{
  CGAL::balanced_flow_smooth_point_set<CGAL::Sequential_tag>(points, arguments...);
  return points;
}

template <typename Given_smoother>
Points scaled(std::size_t iterations, const Given_smoother& smoother)
{
  const Points noisy = noisy_sphere();
  Reconstruction reconstruction(noisy.begin(), noisy.end());
  reconstruction.increase_scale(iterations, smoother);
  return Points(reconstruction.points_begin(), reconstruction.points_end());
}

double rms_error(const Points& points)
{
  double sum = 0.;
  for (const auto& p : points)
    sum += std::pow(std::sqrt((p - CGAL::ORIGIN).squared_length()) - 2., 2);
  return std::sqrt(sum / double(points.size()));
}

} // namespace

// ---- the points are those of the function

static_assert(std::is_same<Smoother::FT, Kernel::FT>::value &&
                  std::is_same<Smoother::Point, Kernel::Point_3>::value,
              "the types of Jet_smoother");

BOOST_AUTO_TEST_CASE(the_points_are_those_of_the_function)
{
  const Points noisy = noisy_sphere(), once = smoothed(noisy);
  BOOST_TEST((once != noisy));
  BOOST_TEST((scaled(0, Sequential_smoother()) == noisy));
  BOOST_TEST((scaled(1, Sequential_smoother()) == once));
  BOOST_TEST((scaled(2, Sequential_smoother()) == smoothed(once)));
  BOOST_TEST((scaled(1, Sequential_smoother(12)) == smoothed(noisy, 12)));
  BOOST_TEST((smoothed(noisy, 12) != once));
}

BOOST_AUTO_TEST_CASE(sequential_and_parallel_results_are_bitwise_identical)
{
  BOOST_TEST((scaled(2, Smoother()) == scaled(2, Sequential_smoother())));
  BOOST_TEST((scaled(1, Smoother(20)) == scaled(1, Sequential_smoother(20))));
}

BOOST_AUTO_TEST_CASE(any_forward_iterator_is_enough)
{
  const Points noisy = noisy_sphere();
  std::list<Kernel::Point_3> list(noisy.begin(), noisy.end());
  const Sequential_smoother smoother;
  smoother(list.begin(), list.end());
  BOOST_TEST((Points(list.begin(), list.end()) == smoothed(noisy)));
  smoother(list.end(), list.end());
}

// ---- in a pipeline

BOOST_AUTO_TEST_CASE(a_noisy_sphere_becomes_a_closed_surface)
{
  const Points noisy = noisy_sphere();
  Reconstruction reconstruction(noisy.begin(), noisy.end());
  reconstruction.increase_scale<Smoother>(2); // as with Jet_smoother
  reconstruction.reconstruct_surface(Mesher());

  const Points points(reconstruction.points_begin(), reconstruction.points_end());
  BOOST_TEST(points.size() == noisy.size());
  BOOST_TEST(rms_error(points) < .3 * rms_error(noisy));

  // closed: each directed edge has its opposite; a sphere: V - E + F = 2
  std::map<std::pair<std::size_t, std::size_t>, int> edges;
  std::map<std::size_t, int> vertices;
  for (auto f = reconstruction.facets_begin(); f != reconstruction.facets_end(); ++f)
    for (std::size_t i = 0; i < 3; ++i) {
      ++edges[{(*f)[i], (*f)[(i + 1) % 3]}];
      ++vertices[(*f)[i]];
    }
  std::size_t open = 0;
  for (const auto& edge : edges)
    open += edge.second != 1 || edges.count({edge.first.second, edge.first.first}) == 0;
  BOOST_TEST(open == 0u);
  BOOST_TEST(vertices.size() + reconstruction.number_of_facets() == edges.size() / 2 + 2);
}
