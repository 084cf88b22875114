// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_PAPER_ANISOTROPY_FIGURE_H
#define POINT_SET_FLOW_PAPER_ANISOTROPY_FIGURE_H

#include "Paper_case.h"
#include "Tuning.h"

namespace comparison {

/// Fig. 4: a noisy part with edges after the curvature flow, the naive and the well-posed anisotropic flow,
/// each with the K that suits it best
inline void anisotropy_figure(const Run_settings& s)
{
  using namespace CGAL::Point_set_flow;
  const Paper_case data(load_shape("fandisk", 0), s.points(15000), .01);
  Figure figure(s.folder, "fig4");
  Result_table table;
  const double range = 3.;
  figure.set_range(-range, range, "signed distance from the true surface, % of the radius");
  const auto add = [&](const std::string& title, const Tuned& tuned) {
    const Surface_errors found(tuned.points, *data.surface, data.clean.near_edge);
    Error_sum flat;
    Numbers values;
    for (std::size_t i = 0; i < tuned.points.size(); ++i) {
      if (!data.clean.near_edge[i])
        flat.add(percent * found.signed_distances[i]);
      values.push_back(percent * found.signed_distances[i]);
    }
    const double edges = percent * found.near_edges.rms();
    table.add(title, {{"rms error", percent * found.all.rms()},
                      {"rms error near edges", edges},
                      {"rms error elsewhere", flat.rms()},
                      {"g is 1/2 at", tuned.value}});
    figure.add_points(title + "|rms near edges " + text(edges) + "%, elsewhere " +
                          text(flat.rms()) + "%",
                      tuned.points, values);
  };
  const auto as_it_is = [&](const Points& points) {
    return Tuned(
        {unknown}, [&](double) { return points; }, [](const Points&) { return 0.; });
  };
  const auto flow = [&](const Paper_flow& f, unsigned int steps) {
    return run_tuned_flow(data.noisy, f, {s.steps(steps), 0},
                          [&](const Points& p) { return data.rms_error(p); });
  };
  const auto curvature_flow = [&](unsigned int steps) { // has no K
    return as_it_is(run_flow(data.noisy, Curvature_flow(), {s.steps(steps), 0}));
  };
  add("a: noisy", as_it_is(data.noisy));
  add("b: curvature flow (4)", curvature_flow(40));
  add("c: naive anisotropic (5)", flow(Anisotropic_flow(), 40));
  add("d: well-posed anisotropic (6)", flow(Well_posed_anisotropic_flow(), 40));
  add("e: balanced (9)", flow(Balanced_flow(), 40));
  add("f: this package, defaults", as_it_is(point_set_flow(data.noisy).points));
  figure.write_table(table);

  // where one stops matters, too
  Result_table over_time;
  for (const unsigned int steps : {10u, 20u, 40u, 80u}) {
    Result_table::Named_numbers all, near_edges;
    const auto add_flow = [&](const std::string& name, const Tuned& tuned) {
      const Surface_errors found(tuned.points, *data.surface, data.clean.near_edge);
      all.emplace_back(name, percent * found.all.rms());
      near_edges.emplace_back(name + ", near edges", percent * found.near_edges.rms());
    };
    add_flow("Eq. (4)", curvature_flow(steps));
    add_flow("Eq. (5)", flow(Anisotropic_flow(), steps));
    add_flow("Eq. (6)", flow(Well_posed_anisotropic_flow(), steps));
    all.insert(all.end(), near_edges.begin(), near_edges.end());
    over_time.add(std::to_string(steps) + " steps", all);
  }
  figure.write_table(over_time, "_steps");
}

} // namespace comparison

#endif // POINT_SET_FLOW_PAPER_ANISOTROPY_FIGURE_H
