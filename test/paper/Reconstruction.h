// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_PAPER_RECONSTRUCTION_H
#define POINT_SET_FLOW_PAPER_RECONSTRUCTION_H

#include "Figure.h"

#include <CGAL/Advancing_front_surface_reconstruction.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <boost/pending/disjoint_sets.hpp>

#include <map>
#include <set>

namespace comparison {

/// A surface through points by CGAL's advancing front, with its default parameters
inline Triangles reconstruct(const Points& points)
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel::Point_3 Exact_point_3;
  std::vector<Exact_point_3> exact;
  for (const Point_3& p : points)
    exact.emplace_back(p.x(), p.y(), p.z());
  Triangles triangles;
  CGAL::advancing_front_surface_reconstruction(exact.begin(), exact.end(),
                                               std::back_inserter(triangles));
  return triangles;
}

/// What is wrong with a surface, without a truth.
struct Surface_quality {
  std::size_t borders = 0; ///< closed lines of edges with one triangle only: holes, and the rim
  double border_length = 0.;
  double bend = 0.; ///< mean angle in degrees between neighboring triangles

  Surface_quality(const Points& points, const Triangles& triangles)
  {
    typedef std::pair<std::size_t, std::size_t> Edge;
    std::map<Edge, std::vector<std::size_t>> edges;
    Vectors normals;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      const auto& v = triangles[t];
      normals.push_back(
          CGAL::cross_product(points[v[1]] - points[v[0]], points[v[2]] - points[v[0]]));
      for (std::size_t i = 0; i < 3; ++i)
        edges[std::minmax(v[i], v[(i + 1) % 3])].push_back(t);
    }
    std::vector<std::size_t> rank(points.size()), parent(points.size());
    boost::disjoint_sets<std::size_t*, std::size_t*> lines(rank.data(), parent.data());
    for (std::size_t i = 0; i < points.size(); ++i)
      lines.make_set(i);
    std::set<std::size_t> on_border;
    Error_sum angles;
    for (const auto& [edge, sides] : edges) {
      if (sides.size() == 1) {
        lines.union_set(edge.first, edge.second);
        on_border.insert({edge.first, edge.second});
        border_length += std::sqrt(CGAL::squared_distance(points[edge.first], points[edge.second]));
      }
      else
        angles.add(CGAL::approximate_angle(normals[sides[0]], normals[sides[1]]));
    }
    std::set<std::size_t> roots;
    for (const std::size_t v : on_border)
      roots.insert(lines.find_set(v));
    borders = roots.size();
    bend = angles.mean();
  }
};

/// How much of the relief of a surface is left: the height of the mean of the nearest 12 points above that of the
/// nearest 96, along the normal of these. Noise hardly takes part in such means; hair, fur and ornaments do.
class Relief {
  std::vector<std::vector<std::size_t>> m_neighbors;
  Vectors m_normals;
  Numbers m_heights;

  static constexpr unsigned int fine = 12, coarse = 96;

  double height(const Points& points, std::size_t i) const
  {
    Vector_3 difference = CGAL::NULL_VECTOR;
    for (std::size_t j = 0; j < m_neighbors[i].size(); ++j) {
      const Vector_3 d = points[m_neighbors[i][j]] - points[i];
      difference -= d / double(m_neighbors[i].size());
      if (j < fine)
        difference += d / double(fine);
    }
    return difference * m_normals[i];
  }

public:
  /// \param points with the relief that counts as the whole
  explicit Relief(const Points& points)
      : m_normals(normals_in_order(with_normals<CGAL::Sequential_tag>(points, false, coarse)))
  {
    const Nearest_points nearest(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      m_neighbors.emplace_back();
      for (const auto& found : nearest(points[i], coarse))
        m_neighbors.back().push_back(found.first);
      m_heights.push_back(height(points, i));
    }
  }

  /// The slope of a line through the heights then against those now: 1 if all is left
  double kept(const Points& points) const
  {
    double product = 0., square = 0.;
    for (std::size_t i = 0; i < points.size(); ++i) {
      product += height(points, i) * m_heights[i];
      square += m_heights[i] * m_heights[i];
    }
    return product / square;
  }
};

} // namespace comparison

#endif // POINT_SET_FLOW_PAPER_RECONSTRUCTION_H
