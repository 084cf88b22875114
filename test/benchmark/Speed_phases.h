// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_BENCHMARK_SPEED_PHASES_H
#define POINT_SET_FLOW_BENCHMARK_SPEED_PHASES_H

#include "measure/Surface.h"

#include <CGAL/Real_timer.h>
#include <CGAL/balanced_flow_smooth_point_set.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

namespace comparison {

struct Phase {
  std::string name;
  double cost; // what it counts in the progress
  double seconds = 0.;
  double interval = 0.; // the longest time between two calls of the callback
};
typedef std::vector<Phase> Phases;

/// The phases of a run with default parameters in one block, one after the other
inline Phases phases_of_a_run()
{
  using namespace CGAL::Point_set_flow::internal;
  typedef Default_curvature Curvature;
  namespace costs = stage_costs;
  Phases phases = {{"copy in, order", costs::order}, {"tree", costs::tree},
                   {"graph", costs::graph},          {"scale", costs::scale},
                   {"adapt", costs::adapt},          {"tangent planes", costs::planes},
                   {"two sheets", costs::sheets}};
  for (unsigned int round = 0; round < Number_of_sheet_rounds<Curvature>::value; ++round)
    phases.push_back({"learned: sheets", costs::network});
  phases.push_back({"shrink", costs::shrink});
  phases.push_back({"flow steps", costs::step});
  for (unsigned int t = 1; t < Defaults_of<Curvature>::get().number_of_iterations; ++t) {
    phases.push_back({"tangent planes", costs::planes});
    phases.push_back({"flow steps", costs::step});
  }
  for (unsigned int round = 0; round < Number_of_corrections<Curvature>::value; ++round)
    phases.push_back({"learned: correction", costs::network});
  phases.push_back({"copy out", 0.});
  return phases;
}

/// The seconds that each phase of a run takes, read off its progress
inline Phases measure_phases(Points points, [[maybe_unused]] unsigned int threads)
{
  const Phases sequence = phases_of_a_run();
  double total = 0.;
  for (const Phase& phase : sequence)
    total += phase.cost;

  Phases phases; // each name once
  const auto add = [&](const std::string& name, double seconds) {
    auto found = std::find_if(phases.begin(), phases.end(),
                              [&](const Phase& phase) { return phase.name == name; });
    if (found == phases.end())
      found = phases.insert(found, Phase{name, 0.});
    found->seconds += seconds;
    found->interval = (std::max)(found->interval, seconds);
  };
  std::size_t at = 0;
  double end = sequence[0].cost / total, before = 0.;
  CGAL::Real_timer timer;
  const auto clock = [&](double share) {
    const double now = timer.time();
    add(sequence[at].name, now - before);
    before = now;
    while (at + 1 < sequence.size() && share > (std::min)(end, .999) - 1e-9)
      end += sequence[++at].cost / total;
    return true;
  };
  timer.start();
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
  if (threads > 1)
    CGAL::balanced_flow_smooth_point_set<CGAL::Parallel_tag>(points,
                                                             CGAL::parameters::callback(clock));
  else
#endif
    CGAL::balanced_flow_smooth_point_set<CGAL::Sequential_tag>(points,
                                                               CGAL::parameters::callback(clock));
  add("copy out", timer.time() - before);
  return phases;
}

inline double median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values.empty() ? std::numeric_limits<double>::quiet_NaN() : values[values.size() / 2];
}

/// The medians of some runs, which have the same phases
inline Phases median_phases(const std::vector<Phases>& runs)
{
  Phases medians = runs.front();
  for (std::size_t i = 0; i < medians.size(); ++i) {
    std::vector<double> seconds, intervals;
    for (const Phases& run : runs) {
      seconds.push_back(run[i].seconds);
      intervals.push_back(run[i].interval);
    }
    medians[i].seconds = median(seconds);
    medians[i].interval = median(intervals);
  }
  return medians;
}

} // namespace comparison

#endif // POINT_SET_FLOW_BENCHMARK_SPEED_PHASES_H
