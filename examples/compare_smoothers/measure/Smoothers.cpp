// SPDX-License-Identifier: GPL-3.0-or-later
#include "Smoothers.h"

#include <CGAL/balanced_flow_smooth_point_set.h>
#include <CGAL/bilateral_smooth_point_set.h>
#include <CGAL/jet_smooth_point_set.h>
#include <CGAL/wlop_simplify_and_regularize_point_set.h>

namespace comparison {

Smoothed jet(const Points& noisy, unsigned int k, int times)
{
  Smoothed result{noisy, {}};
  for (int i = 0; i < times; ++i)
    CGAL::jet_smooth_point_set<Concurrency_tag>(result.points, k);
  return result;
}

Smoothed bilateral(Numbered_points points, unsigned int k, int times)
{
  for (int i = 0; i < times; ++i)
    CGAL::bilateral_smooth_point_set<Concurrency_tag>(points, k,
                                                      numbered_point_maps().sharpness_angle(25.));
  Smoothed result{Points(points.size()), {}};
  for (const Numbered_point& p : points)
    result.points[std::get<2>(p)] = std::get<0>(p);
  return result;
}

Smoothed bilateral(const Points& noisy, unsigned int k, int times)
{
  return bilateral(with_normals<Concurrency_tag>(noisy, true), k, times);
}

Smoothed wlop(Points noisy)
{
  Smoothed result;
  CGAL::wlop_simplify_and_regularize_point_set<Concurrency_tag>(
      noisy, std::back_inserter(result.points), CGAL::parameters::select_percentage(100.));
  result.same_points = false;
  return result;
}

std::vector<std::size_t> numbers(std::size_t n)
{
  std::vector<std::size_t> result(n);
  for (std::size_t i = 0; i < n; ++i)
    result[i] = i;
  return result;
}

template <typename Flow>
Smoothed paper_flow(const Points& noisy, const Flow& flow)
{
  Smoothed result{noisy, Vectors(noisy.size(), CGAL::NULL_VECTOR)};
  std::vector<std::size_t> indices = numbers(noisy.size());
  CGAL::balanced_flow_smooth_point_set<Concurrency_tag>(
      indices, CGAL::parameters::flow(flow)
                   .curvature(CGAL::Point_set_flow::Covariance_curvature())
                   .point_map(CGAL::make_property_map(result.points))
                   .normal_map(CGAL::make_property_map(result.normals)));
  return result;
}

namespace flows = CGAL::Point_set_flow;
template Smoothed paper_flow(const Points&, const flows::Curvature_flow&);
template Smoothed paper_flow(const Points&, const flows::Anisotropic_flow&);
template Smoothed paper_flow(const Points&, const flows::Well_posed_anisotropic_flow&);
template Smoothed paper_flow(const Points&, const flows::Volume_preserving_flow&);
template Smoothed paper_flow(const Points&, const flows::Balanced_flow&);

Smoothed point_set_flow_relaxed(const Points& noisy, unsigned int steps)
{
  Smoothed result{noisy, Vectors(noisy.size(), CGAL::NULL_VECTOR)};
  std::vector<std::size_t> indices = numbers(noisy.size());
  CGAL::balanced_flow_smooth_point_set<Concurrency_tag>(
      indices, CGAL::parameters::number_of_relaxation_steps(steps)
                   .point_map(CGAL::make_property_map(result.points))
                   .normal_map(CGAL::make_property_map(result.normals)));
  return result;
}

Smoothed point_set_flow(const Points& noisy) { return point_set_flow_relaxed(noisy, 0); }

Smoothed point_set_flow(const Points& noisy, unsigned int k)
{
  Smoothed result{noisy, {}};
  CGAL::balanced_flow_smooth_point_set<Concurrency_tag>(result.points, k);
  return result;
}

} // namespace comparison
