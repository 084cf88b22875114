// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_PAPER_PAPER_CASE_H
#define POINT_SET_FLOW_PAPER_PAPER_CASE_H

#include "Figure.h"

#include "../benchmark/Benchmark_shapes.h"
#include "measure/Noise_models.h"
#include "measure/sample_mesh.h"

namespace comparison {

/// What all experiments get.
struct Run_settings {
  std::filesystem::path folder;
  bool quick = false; ///< few points: a smoke test

  std::size_t points(std::size_t n) const { return quick ? n / 15 : n; }
  unsigned int steps(unsigned int n) const { return quick ? (n + 9) / 10 : n; }
};

/// A shape of radius 1, samples of it, and the same with Gaussian noise.
struct Paper_case {
  std::unique_ptr<Mesh_surface> surface;
  Samples clean;
  Points noisy;
  double spacing; ///< of samples that are spread evenly

  /// \param noise the standard deviation in each coordinate
  Paper_case(std::unique_ptr<Mesh_surface> shape, std::size_t n, double noise)
      : surface(std::move(shape))
  {
    if (!surface)
      throw std::runtime_error("a shape can not be read from CGAL's data (libcgal-demo)");
    clean = sample_mesh(*surface, n, 1);
    spacing = std::sqrt(surface->area() / double(n));
    find_samples_near_edges(clean, *surface, 2. * spacing);
    noisy = add_noise(clean.points, "Gaussian", noise, 2).points;
  }

  double rms_error(const Points& points) const
  {
    return Surface_errors(points, *surface, clean.near_edge).all.rms();
  }

  Numbers signed_errors(const Points& points) const
  {
    return Surface_errors(points, *surface, clean.near_edge).signed_distances;
  }
};

constexpr double percent = 100.;

/// The paper's E: the mean distance of points from what they were
inline double mean_distance(const Points& points, const Points& from)
{
  Error_sum sum;
  for (std::size_t i = 0; i < points.size(); ++i)
    sum.add(std::sqrt(CGAL::squared_distance(points[i], from[i])));
  return sum.mean();
}

inline double largest_distance(const Points& points, const Points& from)
{
  Error_sum sum;
  for (std::size_t i = 0; i < points.size(); ++i)
    sum.add(std::sqrt(CGAL::squared_distance(points[i], from[i])));
  return sum.max();
}

/// How far the places of a surface are from the nearest point, in spacings; the points are
/// projected to it first. On samples that are spread evenly it is not more than about 1.
struct Gaps {
  double largest, share; ///< the share of the surface farther than 1.25 spacings from all points

  /// \param places all over the surface, closer to each other than the points
  Gaps(const Paper_case& data, const Points& places, const Points& points)
  {
    Points projected;
    for (const Point_3& p : points)
      projected.push_back(data.surface->closest(p).point);
    const Nearest_points nearest(projected);
    std::size_t far = 0;
    Error_sum sum;
    for (const Point_3& place : places) {
      const double gap = std::sqrt(nearest(place).second) / data.spacing;
      sum.add(gap);
      far += gap > 1.25;
    }
    largest = sum.max();
    share = double(far) / double(places.size());
  }
};

/// The row of a table for points that are samples of a known surface, in percent of its radius
inline Result_table::Named_numbers errors(const Paper_case& data, const Points& points)
{
  const Surface_errors found(points, *data.surface, data.clean.near_edge);
  return {{"E: mean distance from the noisy points", percent * mean_distance(points, data.noisy)},
          {"rms error", percent * found.all.rms()},
          {"rms error near edges", percent * found.near_edges.rms()},
          {"mean signed error (below 0: shrunk)", percent * found.all.mean()}};
}

inline std::string text(double value, int digits = 2)
{
  std::ostringstream out;
  out << std::fixed << std::setprecision(digits) << value;
  return out.str();
}

} // namespace comparison

#endif // POINT_SET_FLOW_PAPER_PAPER_CASE_H
