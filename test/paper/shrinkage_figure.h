// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_PAPER_SHRINKAGE_FIGURE_H
#define POINT_SET_FLOW_PAPER_SHRINKAGE_FIGURE_H

#include "Paper_case.h"
#include "Paper_flow.h"

namespace comparison {

/// Fig. 2: what the curvature flow makes of a noisy head, and how much of it the anisotropic and
/// the volume-preserving flow leave
inline void shrinkage_figure(const Run_settings& s)
{
  using namespace CGAL::Point_set_flow;
  const Paper_case data(load_shape("mannequin-devil", 0), s.points(30000), .01);
  Figure figure(s.folder, "fig2");
  Result_table table;
  const double range = .03;
  figure.set_range(-percent * range, percent * range,
                   "signed distance from the true surface, % of the radius");
  const auto add = [&](const std::string& title, const Points& points) {
    const Result_table::Named_numbers numbers = errors(data, points);
    table.add(title, numbers);
    Numbers values = data.signed_errors(points);
    for (double& v : values)
      v *= percent;
    figure.add_points(title + "|mean signed error " + text(numbers[3].second) + "%", points,
                      values);
  };
  const auto flow = [&](const Paper_flow& f, unsigned int steps, unsigned int update_period) {
    return run_flow(data.noisy, f, {s.steps(steps), update_period});
  };
  add("a: noisy", data.noisy);
  add("b: curvature flow (4), 20 steps", flow(Curvature_flow(), 20, 0));
  add("c: curvature flow (4), 200 steps", flow(Curvature_flow(), 200, 0));
  add("d: well-posed flow (6), 200 steps", flow(Well_posed_anisotropic_flow(), 200, 0));
  add("e: volume-preserving (7), 200 steps", flow(Volume_preserving_flow(), 200, 0));
  add("f: this package, defaults", point_set_flow(data.noisy).points);
  table.add("well-posed flow (6), 1000 steps",
            errors(data, flow(Well_posed_anisotropic_flow(), 1000, 0)));
  figure.write_table(table);
}

} // namespace comparison

#endif // POINT_SET_FLOW_PAPER_SHRINKAGE_FIGURE_H
