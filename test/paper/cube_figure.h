// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_PAPER_CUBE_FIGURE_H
#define POINT_SET_FLOW_PAPER_CUBE_FIGURE_H

#include "Paper_case.h"
#include "Tuning.h"

#include "../support/shapes.h"

namespace comparison {

/// Fig. 7: a noisy cube after 200 steps of the static and 12 of the dynamic flow, each with the K that
/// suits it best; below, the curvature
inline void cube_figure(const Run_settings& s)
{
  using namespace CGAL::Point_set_flow;
  const double radius = std::sqrt(3.); // of the cube [-1, 1]^3
  Points noisy = shapes::cube(s.quick ? 10 : 45);
  shapes::add_noise(noisy, .01 * radius);

  Figure figure(s.folder, "fig7");
  figure.set_range(0., .08, "surface variation of 20 neighbors, Eq. (2)");
  Result_table table;
  std::vector<std::pair<std::string, Numbers>> curvatures;
  std::vector<Points> results;
  const auto add = [&](const std::string& title, const std::string& short_title,
                       const Points& points) {
    Numbers variation, on_faces;
    Error_sum near_edges, faces;
    for (const Seen& seen : what_flows_see(points))
      variation.push_back(seen.variation);
    for (std::size_t i = 0; i < points.size(); ++i) {
      // the second largest coordinate of where the point was tells how near an edge is
      double x[3] = {std::abs(noisy[i].x()), std::abs(noisy[i].y()), std::abs(noisy[i].z())};
      std::sort(x, x + 3);
      const double error = percent / radius * shapes::distance_to_cube(points[i]);
      (x[1] > .9 ? near_edges : faces).add(error);
      if (x[1] <= .9)
        on_faces.push_back(variation[i]);
    }
    std::sort(on_faces.begin(), on_faces.end());
    table.add(title, {{"E: mean distance from the noisy points",
                       percent / radius * mean_distance(points, noisy)},
                      {"rms error on faces", faces.rms()},
                      {"rms error near edges", near_edges.rms()},
                      {"median variation on faces", on_faces[on_faces.size() / 2]}});
    figure.add_points(short_title + "|rms on faces " + text(faces.rms()) + "%", points);
    curvatures.emplace_back("curvature|median on faces " + text(on_faces[on_faces.size() / 2], 4),
                            variation);
    results.push_back(points);
  };
  const auto flow = [&](const Paper_flow& f, unsigned int steps, unsigned int update_period) {
    return run_tuned_flow(noisy, f, {s.steps(steps), update_period},
                          [](const Points& p) { return shapes::rms(p, shapes::distance_to_cube); })
        .points;
  };
  add("a: noisy", "a: noisy", noisy);
  add("b: volume-preserving (7), static, 200 steps", "b: static (7), 200 steps",
      flow(Volume_preserving_flow(), 200, 0));
  add("c: volume-preserving (7), dynamic, 12 steps", "c: dynamic (7), 12 steps",
      flow(Volume_preserving_flow(), 12, 4));
  add("d: balanced (9), dynamic, 12 steps", "d: dynamic (9), 12 steps",
      flow(Balanced_flow(), 12, 4));
  add("e: this package, defaults", "e: this package, defaults", point_set_flow(noisy).points);
  for (std::size_t i = 0; i < results.size(); ++i)
    figure.add_points(curvatures[i].first, results[i], curvatures[i].second);
  figure.write_table(table);
}

} // namespace comparison

#endif // POINT_SET_FLOW_PAPER_CUBE_FIGURE_H
