// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_PAPER_BAND_FIGURE_H
#define POINT_SET_FLOW_PAPER_BAND_FIGURE_H

#include "Paper_case.h"
#include "Paper_flow.h"

namespace comparison {

/// Fig. 5: how far the points go from the reference I, against the width of the diffusion band.
///
/// At rest Eq. (8) says u - I = -g kappa n, and g <= 1: the band is as wide as the largest
/// directional curvature of the reference.
inline void band_figure(const Run_settings& s)
{
  using namespace CGAL::Point_set_flow;
  const Paper_case data(load_shape("mannequin-devil", 0), s.points(12000), .01);
  double band = 0.;
  for (const Seen& seen : what_flows_see(data.noisy))
    band = (std::max)(band, std::abs(seen.directional_curvature));

  struct Run {
    std::string title;
    Paper_flow flow;
    unsigned int update_period;
  };
  const std::vector<Run> runs = {
      {"well-posed (6)", Well_posed_anisotropic_flow(), 0},
      {"volume-preserving (7)", Volume_preserving_flow(), 0},
      {"balanced (9)", Balanced_flow(), 0},
      {"dynamic volume-preserving (7), L=4", Volume_preserving_flow(), 4},
      {"dynamic balanced (9), L=4", Balanced_flow(), 4}};
  Figure figure(s.folder, "fig5");
  Result_table table;
  std::vector<Numbers> curves;
  for (const unsigned int n : {1u, 2u, 4u, 8u, 12u, 20u, 40u, 100u, 200u})
    curves.push_back({double(n)});
  for (const Run& run : runs) {
    Points twelfth, last;
    for (Numbers& row : curves) {
      last = run_flow(data.noisy, run.flow, {s.steps(unsigned(row[0])), run.update_period});
      row.push_back(largest_distance(last, data.noisy) / band);
      if (row[0] == 12.)
        twelfth = last;
    }
    const auto outside = [&](const Points& points) {
      double n = 0.;
      for (std::size_t i = 0; i < points.size(); ++i)
        n += CGAL::squared_distance(points[i], data.noisy[i]) > band * band;
      return n;
    };
    // one more step of length 1 is what is missing in Eq. (8)
    const Points next = run_flow(data.noisy, last, run.flow, {1, 0, 20, 1.});
    table.add(run.title,
              {{"largest distance / band, 12 steps", largest_distance(twelfth, data.noisy) / band},
               {"outside", outside(twelfth)},
               {"largest distance / band, 200 steps", largest_distance(last, data.noisy) / band},
               {"outside, 200 steps", outside(last)},
               {"speed at 200 steps / band",
                run.update_period == 0 ? mean_distance(next, last) / band : unknown}});
  }
  figure.write_curves("fig5_curve", curves);
  figure.write_table(table);
}

} // namespace comparison

#endif // POINT_SET_FLOW_PAPER_BAND_FIGURE_H
