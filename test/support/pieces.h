// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_TEST_PIECES_H
#define CGAL_POINT_SET_FLOW_TEST_PIECES_H

#include "shapes.h"

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <random>
#include <string>
#include <utility>
#include <vector>

// Clouds that are smoothed piece by piece.
namespace pieces {

using shapes::Points;
typedef std::vector<shapes::Vector_3> Normals;
typedef std::vector<std::size_t> Indices;

struct Cloud {
  std::string name;
  Points points;
  Normals normals;                  // empty if not given
  std::vector<std::uint32_t> scans; // the same
  std::vector<char> constrained;    // the same
  std::vector<double> noise;        // the same
  unsigned int relaxation_steps = 0;

  explicit Cloud(std::string n, Points p) : name(std::move(n)), points(std::move(p)) {}
};

/// Pieces of a cloud, some of which were read
struct Pieces {
  struct Piece {
    Indices points;
    CGAL::Bbox_3 box;
    bool is_read = false;
  };
  std::vector<Piece> pieces;

  Pieces(const Points& points, std::size_t size)
  {
    Indices order(points.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    cut(points, size, order.begin(), order.end());
  }

  void read_none()
  {
    for (Piece& piece : pieces)
      piece.is_read = false;
  }

  double distance_to_missing(const shapes::Point_3& p) const
  {
    double least = (std::numeric_limits<double>::infinity)();
    for (const Piece& piece : pieces)
      if (!piece.is_read)
        least = (std::min)(least, distance(p, piece.box));
    return least;
  }
  void require(const shapes::Point_3& center, double radius)
  {
    for (Piece& piece : pieces)
      piece.is_read = piece.is_read || distance(center, piece.box) <= radius;
  }

private:
  // halves along the longest side, so that duplicates may be on both sides of a border
  void cut(const Points& points, std::size_t size, Indices::iterator first, Indices::iterator last)
  {
    CGAL::Bbox_3 box;
    for (auto it = first; it != last; ++it)
      box += points[*it].bbox();
    if (std::size_t(last - first) <= size) {
      pieces.push_back({Indices(first, last), box});
      return;
    }
    int axis = 0;
    for (int d = 1; d < 3; ++d)
      if (box.max(d) - box.min(d) > box.max(axis) - box.min(axis))
        axis = d;
    const auto middle = first + (last - first) / 2;
    std::nth_element(first, middle, last, [&](std::size_t i, std::size_t j) {
      return points[i][axis] < points[j][axis];
    });
    cut(points, size, first, middle);
    cut(points, size, middle, last);
  }

  static double distance(const shapes::Point_3& p, const CGAL::Bbox_3& box)
  {
    const auto beyond = [&](int d) {
      return (std::max)({box.min(d) - p[d], p[d] - box.max(d), 0.});
    };
    return std::hypot(beyond(0), beyond(1), beyond(2)); // squares may be out of range
  }
};

/// All of a cloud but one point
struct All_but_one {
  shapes::Point_3 missing;
  bool is_required = false;

  double distance_to_missing(const shapes::Point_3& p) const
  {
    return std::sqrt(CGAL::squared_distance(p, missing));
  }
  void require(const shapes::Point_3& center, double radius)
  {
    is_required = is_required || distance_to_missing(center) <= radius;
  }
};

/// A strip of n * width points, wavy, with noise that grows along it
/// \param power more than 1: the density falls along the strip
inline Points strip(int n, int width, double power, unsigned int seed)
{
  Points points;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> jitter(-.5, .5);
  std::normal_distribution<double> normal;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < width; ++j) {
      const double u = (i + .5 + jitter(random)) / n, v = (j + jitter(random)) / n;
      const double x = std::pow(u, power);
      points.emplace_back(x, v, .02 * std::sin(9. * x) + (.2 + x) / n * normal(random));
    }
  return points;
}

/// All kinds
inline std::vector<Cloud> clouds()
{
  std::vector<Cloud> all;
  const Points even = strip(1500, 10, 1., 1);
  all.emplace_back("even", even);
  all.emplace_back("of varying density", strip(1500, 10, 2., 2));

  Cloud odd("with duplicates, isolated points and constraints, georeferenced", even);
  for (std::size_t i = 0; i < even.size(); i += 3)
    odd.points.push_back(even[i]);
  for (const double far : {3., 50.})
    odd.points.emplace_back(far, -far, .5);
  for (int i = 0; i < 3; ++i)
    odd.points.emplace_back(.4, .02, -1.);
  for (shapes::Point_3& p : odd.points)
    p = shapes::Point_3(p.x() + 4.5e5, p.y() + 5.4e6, p.z() + 100.);
  for (std::size_t i = 0; i < odd.points.size(); ++i)
    odd.constrained.push_back(i % 7 == 0);
  all.push_back(odd);

  Cloud walls("of two sheets with normals", {});
  std::mt19937 random(5);
  for (const double side : {-1., 1.})
    for (const shapes::Point_3& p : strip(1500, 6, 1.3, side < 0. ? 3 : 4)) {
      walls.points.emplace_back(p.x(), p.y(), p.z() + .001 * side);
      const bool is_known = p.x() > .2 && random() % 10 != 0;
      walls.normals.push_back(is_known ? shapes::Vector_3(0., 0., side)
                                       : shapes::Vector_3(0., 0., 0.));
    }
  all.push_back(walls);
  walls.name = "of two sheets that are found";
  walls.normals.clear();
  all.push_back(walls);
  walls.name = "of two scans";
  for (std::size_t i = 0; i < walls.points.size(); ++i)
    walls.scans.push_back(i < walls.points.size() / 2 ? 1 : 2);
  all.push_back(walls);

  Cloud given("with given noise", even);
  for (const shapes::Point_3& p : even)
    given.noise.push_back(p.y() < .001 ? 0. : .1 * p.y());
  all.push_back(given);
  for (std::size_t i = 1; i < all.size(); i += 2)
    all[i].relaxation_steps = 2;
  return all;
}

} // namespace pieces

#endif // CGAL_POINT_SET_FLOW_TEST_PIECES_H
