// SPDX-License-Identifier: GPL-3.0-or-later
#include "smooth.h"

#include <CGAL/Iterator_range.h>
#include <CGAL/Point_set_flow/Any_flow.h>
#include <CGAL/Point_set_flow/Covariance_curvature.h>
#include <CGAL/Point_set_flow/analyze_point_set.h>
#include <CGAL/Point_set_flow/smooth_block.h>
#include <CGAL/balanced_flow_smooth_point_set.h>
#include <CGAL/property_map.h>

#include <boost/iterator/counting_iterator.hpp>

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

namespace balanced_flow_smooth {

namespace flows = CGAL::Point_set_flow;
using point_files::Point_3;
using point_files::Vector_3;

namespace {

typedef CGAL::Parallel_if_available_tag Concurrency_tag;

/// All flows but the default as one type, which keeps the program small
flows::Any_flow find_flow(const std::string& name)
{
  if (name == "curvature")
    return flows::Curvature_flow();
  if (name == "anisotropic")
    return flows::Anisotropic_flow();
  if (name == "well-posed")
    return flows::Well_posed_anisotropic_flow();
  if (name == "volume-preserving")
    return flows::Volume_preserving_flow();
  return flows::Balanced_flow();
}

/// A property map of normals that may not be there: it is false as a condition then.
struct Optional_normal_map {
  typedef std::size_t key_type;
  typedef Vector_3 value_type;
  typedef const Vector_3& reference;
  typedef boost::lvalue_property_map_tag category;

  std::vector<Vector_3>* normals;

  explicit operator bool() const { return !normals->empty(); }
  friend reference get(const Optional_normal_map& map, std::size_t i) { return (*map.normals)[i]; }
  friend void put(const Optional_normal_map& map, std::size_t i, const Vector_3& normal)
  {
    (*map.normals)[i] = normal;
  }
};

/// Some of the normals as they were
class Kept_normals {
  std::vector<std::pair<std::size_t, Vector_3>> m_kept;

public:
  Kept_normals(const std::vector<Vector_3>& normals, const Smoothing_settings& s)
  {
    for (std::size_t i = 0; i < normals.size(); ++i)
      if (is_known(normals[i]) ? !s.makes_steps() : !s.fills_normals)
        m_kept.emplace_back(i, normals[i]);
  }

  void restore(std::vector<Vector_3>& normals) const
  {
    for (const auto& [i, normal] : m_kept)
      normals[i] = normal;
  }
};

/// Calls `run` with the named parameters that the settings stand for.
template <typename Run>
auto with_parameters(const Smoothing_settings& s, const Run& run)
{
  const auto with_numbers = [&](const auto& flow_and_curvature) {
    const auto with_paper = [&](const auto& own) {
      if (s.feature_threshold && s.filter_width)
        return run(own.feature_threshold(*s.feature_threshold).filter_width(*s.filter_width));
      if (s.feature_threshold)
        return run(own.feature_threshold(*s.feature_threshold));
      if (s.filter_width)
        return run(own.filter_width(*s.filter_width));
      return run(own);
    };
    const auto own = flow_and_curvature.step_length(s.step_length).update_period(s.update_period);
    return s.noise ? with_paper(own.noise(*s.noise)) : with_paper(own);
  };
  if (s.is_paper_estimator())
    return with_numbers(
        CGAL::parameters::flow(find_flow(s.flow)).curvature(flows::Covariance_curvature()));
  if (s.flow == "balanced")
    return with_numbers(CGAL::parameters::flow(flows::Balanced_flow()));
  return with_numbers(CGAL::parameters::flow(find_flow(s.flow)));
}

/// Adds the named parameters of CGAL.
template <typename Own>
auto with_cgal(const Own& own, const Smoothing_settings& s,
               const std::function<bool(double)>& callback)
{
  return own.number_of_iterations(s.iterations)
      .sharpness_angle(s.sharpness_angle)
      .neighbor_radius(s.neighbor_radius)
      .callback(callback);
}

} // namespace

bool is_known(const Vector_3& normal)
{
  const bool is_finite =
      std::isfinite(normal.x()) && std::isfinite(normal.y()) && std::isfinite(normal.z());
  return is_finite && normal != CGAL::NULL_VECTOR;
}

double smooth(std::vector<Point_3>& points, std::vector<Vector_3>& normals,
              const Smoothing_settings& s, const std::function<bool(double)>& callback,
              flows::Smoothing_report& report)
{
  typedef boost::counting_iterator<std::size_t> Index;
  CGAL::Iterator_range<Index> range(Index(0), Index(points.size()));
  const Kept_normals kept(normals, s);
  const double movement = with_parameters(s, [&](const auto& own) {
    const auto all = with_cgal(own.smoothing_report(std::ref(report)), s, callback)
                         .point_map(CGAL::make_property_map(points))
                         .normal_map(Optional_normal_map{&normals});
    return s.k ? CGAL::balanced_flow_smooth_point_set<Concurrency_tag>(range, *s.k, all)
               : CGAL::balanced_flow_smooth_point_set<Concurrency_tag>(range, all);
  });
  kept.restore(normals);
  return movement;
}

bool smooth_block(std::vector<Point_3>& points, std::vector<Vector_3>& normals,
                  std::size_t block_size, const flows::Coordinate_frame& frame, Halo& halo,
                  const Smoothing_settings& s, const std::function<bool(double)>& callback,
                  flows::Smoothing_report& report)
{
  typedef boost::counting_iterator<std::size_t> Index;
  CGAL::Iterator_range<Index> range(Index(0), Index(points.size()));
  const Kept_normals kept(normals, s);
  const flows::Block_status status = with_parameters(s, [&](const auto& own) {
    const auto all = with_cgal(own.smoothing_report(std::ref(report)), s, callback)
                         .point_map(CGAL::make_property_map(points))
                         .normal_map(Optional_normal_map{&normals});
    return s.k ? flows::smooth_block<Concurrency_tag>(range, block_size, frame, halo, *s.k, all)
               : flows::smooth_block<Concurrency_tag>(range, block_size, frame, halo, all);
  });
  kept.restore(normals);
  return status != flows::Block_status::HALO_TOO_SMALL;
}

flows::Smoothing_report analyze(const std::vector<Point_3>& points, const Smoothing_settings& s,
                                const std::function<bool(double)>& callback)
{
  return with_parameters(s, [&](const auto& own) {
    const auto all = with_cgal(own, s, callback);
    return s.k ? flows::analyze_point_set<Concurrency_tag>(points, *s.k, all)
               : flows::analyze_point_set<Concurrency_tag>(points, all);
  });
}

void check(const Smoothing_settings& s)
{
  std::vector<Point_3> no_points;
  std::vector<Vector_3> no_normals;
  flows::Smoothing_report no_report;
  smooth(no_points, no_normals, s, nullptr, no_report);
}

} // namespace balanced_flow_smooth
