// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_PAPER_PLANK_FIGURE_H
#define POINT_SET_FLOW_PAPER_PLANK_FIGURE_H

#include "Paper_case.h"
#include "Tuning.h"

#include "baselines/bilateral_denoising.h"
#include "baselines/laplacian.h"
#include "baselines/non_iterative.h"

namespace comparison {

/// A board with a tongue on one side, a groove in the other and a chamfer
inline std::unique_ptr<Mesh_surface> plank()
{
  return std::make_unique<Mesh_surface>(*prism({{0., 0.},
                                                {1.2, 0.},
                                                {1.2, .14},
                                                {1.34, .14},
                                                {1.34, .26},
                                                {1.2, .26},
                                                {1.2, .4},
                                                {.1, .4},
                                                {0., .3},
                                                {0., .26},
                                                {.14, .26},
                                                {.14, .14},
                                                {0., .14}},
                                               1.6));
}

/// Fig. 8: a plank with noise, by the methods that the paper compares, each with the K or the influence
/// weight that suits it best
inline void plank_figure(const Run_settings& s)
{
  using namespace CGAL::Point_set_flow;
  const Paper_case data(plank(), s.points(20000), .007);
  const Points places = sample_mesh(*data.surface, 2 * data.noisy.size(), 3).points;
  Figure figure(s.folder, "fig8");
  figure.set_range(-2., 2., "signed distance from the true surface, % of the radius");
  Result_table table;
  const auto add_row = [&](const std::string& title, const Points& points) {
    Result_table::Named_numbers row = errors(data, points);
    const Gaps gaps(data, places, points);
    row.erase(row.begin()); // E
    row.insert(row.end(),
               {{"drift", percent * tangential_drift(data.noisy, points, data.clean.normals)},
                {"spacing CV", spacing(points).variation},
                {"largest gap, spacings", gaps.largest},
                {"surface in gaps, %", percent * gaps.share}});
    table.add(title, row);
    return "|rms " + text(row[0].second) + "%, near edges " + text(row[1].second) +
           "%, largest gap " + text(gaps.largest, 1);
  };
  const auto add = [&](const std::string& title, const std::string& steps, const Points& points) {
    const std::string caption = title + add_row(title + steps, points);
    Numbers values = data.signed_errors(points);
    for (double& v : values)
      v *= percent;
    figure.add_points(caption, points, values);
  };
  const auto error = [&](const Points& p) { return data.rms_error(p); };
  const auto flow = [&](const Paper_flow& f) {
    return run_tuned_flow(data.noisy, f, {s.steps(11), 4}, error).points;
  };
  add("a: noisy", "", data.noisy);
  add("b: bilateral", ", 4 iterations",
      Tuned(
          influences, [&](double x) { return bilateral_denoising(data.noisy, 20, 4, x); }, error)
          .points);
  add("c: volume-preserving (7)", ", 11 steps, L=4", flow(Volume_preserving_flow()));
  add("d: balanced (9)", ", 11 steps, L=4", flow(Balanced_flow()));
  add("e: non-iterative, unit areas", "",
      Tuned(
          influences, [&](double x) { return non_iterative(data.noisy, 20, x); }, error)
          .points);
  add("f: this package, defaults", "", point_set_flow(data.noisy).points);

  // with hardly any influence weights, that is without protection of edges
  const double much = influences.back();
  add_row("bilateral, 4 iterations, influence x" + text(much, 0),
          bilateral_denoising(data.noisy, 20, 4, much));
  add_row("non-iterative, unit areas, influence x" + text(much, 0),
          non_iterative(data.noisy, 20, much));
  figure.write_table(table);
}

} // namespace comparison

#endif // POINT_SET_FLOW_PAPER_PLANK_FIGURE_H
