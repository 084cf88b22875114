// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_PAPER_PAPER_FLOW_H
#define POINT_SET_FLOW_PAPER_PAPER_FLOW_H

#include "measure/Smoothers.h"

#include <CGAL/Point_set_flow/Any_flow.h>
#include <CGAL/Point_set_flow/Covariance_curvature.h>
#include <CGAL/balanced_flow_smooth_point_set.h>

namespace comparison {

/// A flow of any kind; one type, so that CGAL is compiled once for all of them. All are run with the
/// prefilter, so that K is chosen from the prefiltered surface for all of them alike.
struct Paper_flow : CGAL::Point_set_flow::Any_flow {
  using CGAL::Point_set_flow::Any_flow::Any_flow;
  bool uses_prefilter() const { return true; }
};

struct Flow_settings {
  unsigned int steps = 12, update_period = 4;
  unsigned int k = 20; // "between 15 and 25" (section 5)
  double step_length = .75, filter_width = .3;
};

/// A flow of the paper from `start`, with the reference `I`, by covariance analysis unless another
/// estimator is given.
template <typename Curvature = CGAL::Point_set_flow::Covariance_curvature>
Points run_flow(const Points& reference, const Points& start, const Paper_flow& flow,
                const Flow_settings& s = Flow_settings())
{
  Points result = reference;
  std::vector<std::size_t> indices = numbers(reference.size());
  CGAL::balanced_flow_smooth_point_set<Concurrency_tag>(
      indices, s.k,
      CGAL::parameters::flow(flow)
          .curvature(Curvature())
          .step_length(s.step_length)
          .filter_width(s.filter_width)
          .update_period(s.update_period)
          .initial_point_map(CGAL::make_property_map(start))
          .number_of_iterations(s.steps)
          .point_map(CGAL::make_property_map(result)));
  return result;
}

/// The same from the reference itself.
inline Points run_flow(const Points& noisy, const Paper_flow& flow, const Flow_settings& s)
{
  return run_flow(noisy, noisy, flow, s);
}

/// What the flows see of one point.
struct Seen {
  double variation, filtered_variation, feature_threshold, directional_curvature;
};

/// What the flows see in their first step: a flow that moves each point by what it sees tells.
inline std::vector<Seen> what_flows_see(const Points& points, unsigned int k = 20,
                                        double filter_width = .3)
{
  using namespace CGAL::Point_set_flow;
  const Flow_settings one_step{1, 0, k, 1., filter_width};
  const Points first = run_flow(
      points,
      [](const Flow_point_3& u, const Diffusivity& g) {
        return Vector_3(u.variation, u.filtered_variation, g.feature_threshold());
      },
      one_step);
  const Points second = run_flow(
      points,
      [](const Flow_point_3& u, const Diffusivity&) {
        return Vector_3(u.directional_curvature, 0., 0.);
      },
      one_step);
  std::vector<Seen> seen;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector_3 d = first[i] - points[i];
    seen.push_back({d.x(), d.y(), d.z(), (second[i] - points[i]).x()});
  }
  return seen;
}

} // namespace comparison

#endif // POINT_SET_FLOW_PAPER_PAPER_FLOW_H
