// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_PAPER_ANISOTROPY_FIGURE_H
#define BALANCED_FLOW_PAPER_ANISOTROPY_FIGURE_H

#include "Paper_case.h"
#include "Paper_flow.h"

/// Fig. 4: a noisy part with edges after the curvature flow, the naive and the well-posed anisotropic flow
inline void anisotropy_figure(const Run_settings& s)
{
  using namespace CGAL::Point_set_flow;
  const Paper_case data(load_shape("fandisk", 0), s.points(30000), .01);
  Figure figure(s.folder, "fig4");
  Result_table table;
  const double range = 3.;
  figure.set_range(-range, range, "signed distance from the true surface, % of the radius");
  const auto add = [&](const std::string& title, const Points& points) {
    const Surface_errors found(points, *data.surface, data.clean.near_edge);
    Error_sum flat;
    Numbers values;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!data.clean.near_edge[i])
        flat.add(percent * found.signed_distances[i]);
      values.push_back(percent * found.signed_distances[i]);
    }
    const double edges = percent * found.near_edges.rms();
    table.add(title, {{"rms error", percent * found.all.rms()},
                      {"rms error near edges", edges},
                      {"rms error elsewhere", flat.rms()}});
    figure.add_points(title + "|rms near edges " + text(edges) + "%, elsewhere " +
                          text(flat.rms()) + "%",
                      points, values);
  };
  const auto flow = [&](const Any_flow& f, unsigned int steps) {
    return run_flow(data.noisy, f, {s.steps(steps), 0});
  };
  add("a: noisy", data.noisy);
  add("b: curvature flow (4)", flow(Curvature_flow(), 40));
  add("c: naive anisotropic (5)", flow(Anisotropic_flow(), 40));
  add("d: well-posed anisotropic (6)", flow(Well_posed_anisotropic_flow(), 40));
  add("e: this package, defaults", balanced_flow(data.noisy).points);
  figure.write_table(table);

  // over time: at which number of steps one stops decides
  Result_table over_time;
  for (const unsigned int steps : {5u, 10u, 20u, 40u, 80u, 160u}) {
    const auto near_edges = [&](const Any_flow& f) {
      const Surface_errors found(flow(f, steps), *data.surface, data.clean.near_edge);
      return std::make_pair(percent * found.all.rms(), percent * found.near_edges.rms());
    };
    const auto curvature = near_edges(Curvature_flow()), naive = near_edges(Anisotropic_flow()),
               well_posed = near_edges(Well_posed_anisotropic_flow());
    over_time.add(std::to_string(steps) + " steps", {{"Eq. (4)", curvature.first},
                                                     {"Eq. (5)", naive.first},
                                                     {"Eq. (6)", well_posed.first},
                                                     {"Eq. (4), near edges", curvature.second},
                                                     {"Eq. (5), near edges", naive.second},
                                                     {"Eq. (6), near edges", well_posed.second}});
  }
  figure.write_table(over_time, "_steps");
}

#endif // BALANCED_FLOW_PAPER_ANISOTROPY_FIGURE_H
