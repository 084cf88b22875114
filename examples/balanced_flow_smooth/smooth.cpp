// SPDX-License-Identifier: GPL-3.0-or-later
#include "smooth.h"

#include "find_flow.h"
#include "find_sides.h"

#include <CGAL/Iterator_range.h>
#include <CGAL/Point_set_flow/Covariance_curvature.h>
#include <CGAL/Point_set_flow/Learned_curvature.h>
#include <CGAL/Point_set_flow/Tangent_plane_curvature.h>
#include <CGAL/Point_set_flow/analyze_point_set.h>
#include <CGAL/Point_set_flow/smooth_block.h>
#include <CGAL/balanced_flow_smooth_point_set.h>
#include <CGAL/property_map.h>

#include <boost/iterator/counting_iterator.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

namespace balanced_flow_smooth {

namespace flows = CGAL::Point_set_flow;
using point_files::Vector_3;

namespace {

typedef CGAL::Parallel_if_available_tag Concurrency_tag;

/// A property map of normals that may not be there: it is false as a condition then.
/// \tparam Normals_reference to a vector, which may be constant
template <typename Normals_reference>
struct Optional_normal_map {
  typedef std::size_t key_type;
  typedef Vector_3 value_type;
  typedef const Vector_3& reference;
  typedef boost::lvalue_property_map_tag category;

  std::remove_reference_t<Normals_reference>* normals;

  explicit operator bool() const { return !normals->empty(); }
  friend reference get(const Optional_normal_map& map, std::size_t i) { return (*map.normals)[i]; }
  friend void put(const Optional_normal_map& map, std::size_t i, const Vector_3& normal)
  {
    (*map.normals)[i] = normal;
  }
};

/// The number of the scan of each point; 0 if all are of one.
struct Scan_map {
  typedef std::size_t key_type;
  typedef std::uint32_t value_type;
  typedef std::uint32_t reference;
  typedef boost::readable_property_map_tag category;

  const std::vector<std::uint32_t>* scans;

  friend std::uint32_t get(const Scan_map& map, std::size_t i)
  {
    return map.scans->empty() ? 0 : (*map.scans)[i];
  }
};

typedef boost::counting_iterator<std::size_t> Index;
typedef CGAL::Iterator_range<Index> Indices;

/// Calls `run` with the named parameters that the settings stand for.
template <typename Run>
auto with_parameters(const Smoothing_settings& s, const Run& run)
{
  const auto own = CGAL::parameters::flow(find_flow(s.flow))
                       .step_length(s.step_length)
                       .update_period(s.update_period)
                       .noise(s.noise)
                       .feature_threshold(s.feature_threshold)
                       .filter_width(s.filter_width);
  if (s.is_paper_estimator())
    return run(own.curvature(flows::Covariance_curvature()));
  if (s.curvature == "tangent-plane")
    return run(own.curvature(flows::Tangent_plane_curvature()));
  return run(own.curvature(flows::Learned_curvature()));
}

/// Adds those that do not depend on the settings, and those of CGAL.
/// \tparam Any_cloud constant if it is not to be written
template <typename Own, typename Any_cloud>
auto with_cloud(const Own& own, Any_cloud& cloud, const Smoothing_settings& s,
                const Callback& callback)
{
  return own.scan_map(Scan_map{&cloud.scans})
      .number_of_iterations(s.iterations)
      .number_of_relaxation_steps(s.relaxation_steps)
      .sharpness_angle(s.sharpness_angle)
      .neighbor_radius(s.neighbor_radius)
      .callback(callback)
      .point_map(CGAL::make_property_map(cloud.points))
      .normal_map(Optional_normal_map<decltype((cloud.normals))>{&cloud.normals});
}

} // namespace

void smooth(Cloud& cloud, const Index_range& range, const Smoothing_settings& s,
            const Callback& callback, flows::Smoothing_report& report)
{
  Indices indices(Index(range.begin), Index(range.end));
  with_parameters(s, [&](const auto& own) {
    const auto all = with_cloud(own.smoothing_report(std::ref(report)), cloud, s, callback);
    return s.k ? CGAL::balanced_flow_smooth_point_set<Concurrency_tag>(indices, *s.k, all)
               : CGAL::balanced_flow_smooth_point_set<Concurrency_tag>(indices, all);
  });
}

bool smooth_block(Cloud& cloud, std::size_t block_size, const flows::Coordinate_frame& frame,
                  Halo& halo, const Smoothing_settings& s, const Callback& callback,
                  flows::Smoothing_report& report)
{
  Indices indices(Index(0), Index(cloud.points.size()));
  const flows::Block_status status = with_parameters(s, [&](const auto& own) {
    const auto all = with_cloud(own.smoothing_report(std::ref(report)), cloud, s, callback);
    return s.k ? flows::smooth_block<Concurrency_tag>(indices, block_size, frame, halo, *s.k, all)
               : flows::smooth_block<Concurrency_tag>(indices, block_size, frame, halo, all);
  });
  return status != flows::Block_status::HALO_TOO_SMALL;
}

flows::Smoothing_report analyze(const Cloud& cloud, const Smoothing_settings& s,
                                const Callback& callback)
{
  const Indices indices(Index(0), Index(cloud.points.size()));
  return with_parameters(s, [&](const auto& own) {
    const auto all = with_cloud(own, cloud, s, callback);
    return s.k ? flows::analyze_point_set<Concurrency_tag>(indices, *s.k, all)
               : flows::analyze_point_set<Concurrency_tag>(indices, all);
  });
}

bool keeps_normal(const point_files::Vector_3& normal, const Smoothing_settings& s)
{
  return is_known(normal) ? !s.makes_steps() : !s.fills_normals;
}

void check(const Smoothing_settings& s)
{
  Cloud nothing;
  flows::Smoothing_report no_report;
  smooth(nothing, {0, 0}, s, nullptr, no_report);
}

} // namespace balanced_flow_smooth
