// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_BENCHMARK_SPEED_PHASES_H
#define BALANCED_FLOW_BENCHMARK_SPEED_PHASES_H

#include "comparison/Numbered_points.h"

#include <CGAL/Real_timer.h>
#include <CGAL/balanced_flow_smooth_point_set.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

/// The phases of a run with default parameters, in one piece, with what they count in the progress
inline std::vector<std::pair<std::string, double>> phases_of_a_run()
{
  using namespace CGAL::Point_set_flow::internal;
  typedef CGAL::Point_set_flow::Tangent_plane_curvature Curvature;
  std::vector<std::pair<std::string, double>> phases = {
      {"1 copy in, order", work::order},  {"2 tree", work::tree},
      {"3 scale", work::scale},           {"4 graph", work::graph},
      {"5 noise map", work::noise},       {"6 tangent planes", work::planes},
      {"7 thin parts", work::thin_parts}, {"8 shrink", work::shrink},
      {"9 flow steps", work::step}};
  for (unsigned int t = 1; t < Defaults_of<Curvature>::get().number_of_iterations; ++t) {
    phases.emplace_back("6 tangent planes", work::planes);
    phases.emplace_back("9 flow steps", work::step);
  }
  return phases;
}

/// The seconds that each phase of a run takes, read off its progress
template <typename Concurrency_tag>
std::map<std::string, double> measure_phases(Points points)
{
  const auto phases = phases_of_a_run();
  double total = 0.;
  for (const auto& phase : phases)
    total += phase.second;

  std::map<std::string, double> seconds;
  std::size_t phase = 0;
  double end = phases[0].second / total, before = 0.;
  CGAL::Real_timer timer;
  const std::function<bool(double)> clock = [&](double share) {
    while (phase < phases.size() && share > end + 1e-9)
      if (++phase < phases.size())
        end += phases[phase].second / total;
    seconds[phase < phases.size() ? phases[phase].first : "10 copy out"] += timer.time() - before;
    before = timer.time();
    return true;
  };
  timer.start();
  CGAL::balanced_flow_smooth_point_set<Concurrency_tag>(points, CGAL::parameters::callback(clock));
  seconds["10 copy out"] += timer.time() - before;
  return seconds;
}

#endif // BALANCED_FLOW_BENCHMARK_SPEED_PHASES_H
