// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_PAPER_CONVERGENCE_FIGURE_H
#define POINT_SET_FLOW_PAPER_CONVERGENCE_FIGURE_H

#include "Paper_case.h"
#include "Paper_flow.h"

namespace comparison {

/// Fig. 6: the reference I is the clean head M_0, the flow starts at a corrupted one, Eq. (7b)
inline void convergence_figure(const Run_settings& s)
{
  using namespace CGAL::Point_set_flow;
  const Paper_case data(load_shape("mannequin-devil", 0), s.points(12000), .02);
  const Points &clean = data.clean.points, &corrupted = data.noisy;
  const auto after = [&](const Paper_flow& flow, unsigned int steps) {
    return run_flow(clean, corrupted, flow, {steps, 0});
  };

  Figure figure(s.folder, "fig6");
  figure.set_range(0., 5., "distance of each point from its place in M0, % of the radius");
  const auto add = [&](const std::string& title, const Points& points) {
    Numbers values;
    for (std::size_t i = 0; i < points.size(); ++i)
      values.push_back(percent * std::sqrt(CGAL::squared_distance(points[i], clean[i])));
    figure.add_points(title + "|E = " + text(percent * mean_distance(points, clean), 3) + "%",
                      points, values);
  };
  add("a: M0, the reference", clean);
  add("b: M', the start", corrupted);
  add("c: after 1 step of Eq. (7)", after(Volume_preserving_flow(), 1));
  add("d: after 2 steps", after(Volume_preserving_flow(), 2));
  add("e: after 30 steps", after(Volume_preserving_flow(), s.steps(30)));

  std::vector<Numbers> curves;
  for (unsigned int n = 0; n <= s.steps(30); ++n) {
    const auto tangent_planes = run_flow<Tangent_plane_curvature>(
        clean, corrupted, Volume_preserving_flow(), {n, 0, 20, .75, .6});
    curves.push_back({double(n), percent * mean_distance(after(Volume_preserving_flow(), n), clean),
                      percent * mean_distance(after(Balanced_flow(), n), clean),
                      percent * mean_distance(tangent_planes, clean)});
  }
  figure.write_curves("fig6_curve", curves);
  Result_table table;
  for (std::size_t n : {0, 1, 2, 3, 5, 10, 30})
    if (n < curves.size())
      table.add(std::to_string(n) + " steps", {{"E, Eq. (7)", curves[n][1]},
                                               {"E, Eq. (9)", curves[n][2]},
                                               {"E, Eq. (7), default estimator", curves[n][3]}});
  figure.write_table(table);
}

} // namespace comparison

#endif // POINT_SET_FLOW_PAPER_CONVERGENCE_FIGURE_H
