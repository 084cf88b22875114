// SPDX-License-Identifier: GPL-3.0-or-later
#include "smooth.h"

#include <CGAL/Iterator_range.h>
#include <CGAL/Point_set_flow/Covariance_curvature.h>
#include <CGAL/balanced_flow_smooth_point_set.h>
#include <CGAL/property_map.h>

#include <boost/iterator/counting_iterator.hpp>

#include <cstddef>
#include <stdexcept>
#include <string>

namespace balanced_flow_smooth {

namespace flows = CGAL::Point_set_flow;
using point_files::Point_3;
using point_files::Vector_3;

namespace {

typedef CGAL::Parallel_if_available_tag Concurrency_tag;

/// All flows but the default as one type, which keeps the program small
typedef std::function<flows::Vector_3(const flows::Flow_point_3&, const flows::Diffusivity&)> Flow;

Flow find_flow(const std::string& name)
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

template <typename Curvature>
Parameters find_parameters(const std::vector<Point_3>& points, const Smoothing_settings& s,
                           const std::function<bool(double)>& callback)
{
  namespace core = flows::internal;
  core::Options options;
  options.k = s.k;
  options.neighbor_radius = s.neighbor_radius;
  options.number_of_iterations = s.iterations;
  options.sharpness_angle = s.sharpness_angle;
  options.feature_threshold = s.feature_threshold;
  options.filter_width = s.filter_width;

  core::Progress progress(callback, core::work::order + core::work::tree + core::work::scale);
  core::Array<flows::Point_3> copy =
      core::copy_in<Point_3>(points, CGAL::Identity_property_map<Point_3>(), "points");
  const core::Frame frame = core::find_frame(Concurrency_tag(), copy, progress);
  core::move_to_core(copy, frame);
  const core::Point_buffer buffer(Concurrency_tag(), copy, {}, {}, progress, core::work::order);
  copy = core::Array<flows::Point_3>(); // memory
  const core::Neighbor_tree tree(Concurrency_tag(), buffer.reference, progress);
  const core::Flow_plan<Flow, Curvature> plan(Concurrency_tag(), buffer, tree, Curvature(), options,
                                              frame.unit, progress);

  Parameters found;
  found.noise = plan.noise_map.noise() * frame.unit;
  found.spacing = plan.noise_map.spacing() * frame.unit;
  found.filter_width = plan.filter_width;
  found.feature_threshold = plan.diffusivity.feature_threshold();
  found.fewest_neighbors = found.most_neighbors = unsigned(plan.search.k);
  if (plan.uses_normals && !s.k && plan.noise_map.spacing() > 0.) {
    found.most_neighbors = 0;
    for (const double noise :
         plan.noise_map.noise_at(Concurrency_tag(), buffer.reference, progress, 0.)) {
      const unsigned int k =
          core::neighborhood_size(plan.defaults, noise / plan.noise_map.spacing());
      found.fewest_neighbors = (std::min)(found.fewest_neighbors, k);
      found.most_neighbors = (std::max)(found.most_neighbors, k);
    }
  }
  return found;
}

} // namespace

double smooth(std::vector<Point_3>& points, std::vector<Vector_3>& normals,
              const Smoothing_settings& s, const std::function<bool(double)>& callback)
{
  typedef boost::counting_iterator<std::size_t> Index;
  CGAL::Iterator_range<Index> range(Index(0), Index(points.size()));
  const auto run = [&](const auto& own) {
    const auto all = own.step_length(s.step_length)
                         .update_period(s.update_period)
                         .number_of_iterations(s.iterations)
                         .sharpness_angle(s.sharpness_angle)
                         .neighbor_radius(s.neighbor_radius)
                         .point_map(CGAL::make_property_map(points))
                         .normal_map(Optional_normal_map{&normals})
                         .callback(callback);
    return s.k ? CGAL::balanced_flow_smooth_point_set<Concurrency_tag>(range, *s.k, all)
               : CGAL::balanced_flow_smooth_point_set<Concurrency_tag>(range, all);
  };
  const auto with_numbers = [&](const auto& own) {
    if (s.feature_threshold && s.filter_width)
      return run(own.feature_threshold(*s.feature_threshold).filter_width(*s.filter_width));
    if (s.feature_threshold)
      return run(own.feature_threshold(*s.feature_threshold));
    if (s.filter_width)
      return run(own.filter_width(*s.filter_width));
    return run(own);
  };
  if (s.is_paper_estimator())
    return with_numbers(
        CGAL::parameters::flow(find_flow(s.flow)).curvature(flows::Covariance_curvature()));
  if (s.flow == "balanced")
    return with_numbers(CGAL::parameters::flow(flows::Balanced_flow()));
  return with_numbers(CGAL::parameters::flow(find_flow(s.flow)));
}

void check(const Smoothing_settings& s)
{
  std::vector<Point_3> no_points;
  std::vector<Vector_3> no_normals;
  smooth(no_points, no_normals, s, nullptr);
}

std::optional<Parameters> find_parameters(const std::vector<Point_3>& points,
                                          const Smoothing_settings& s,
                                          const std::function<bool(double)>& callback)
{
  try {
    return s.is_paper_estimator()
               ? find_parameters<flows::Covariance_curvature>(points, s, callback)
               : find_parameters<flows::Tangent_plane_curvature>(points, s, callback);
  }
  catch (const flows::internal::Cancelled&) {
    return std::nullopt;
  }
}

} // namespace balanced_flow_smooth
