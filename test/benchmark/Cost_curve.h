// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_BENCHMARK_COST_CURVE_H
#define POINT_SET_FLOW_BENCHMARK_COST_CURVE_H

#include "Targets.h"

#include "measure/Smoothing_measures.h"

#include <CGAL/Point_set_flow/estimate_point_set_scale.h>
#include <CGAL/Real_timer.h>
#include <CGAL/balanced_flow_smooth_point_set.h>
#include <CGAL/jet_smooth_point_set.h>

#include <functional>
#include <string>
#include <vector>

namespace comparison {

/// What more or fewer steps and neighbors cost and bring, against one pass of jet smoothing with
/// k = 24: means over all cases, one thread.
class Cost_curve {
  struct Setting {
    std::string name;
    std::function<void(Points&)> smooth;
    Ratios times, errors;
  };
  std::vector<Setting> m_settings;

  static double measure(const std::function<void(Points&)>& smooth, Points& points)
  {
    CGAL::Real_timer timer;
    timer.start();
    smooth(points);
    return timer.time();
  }

public:
  Cost_curve()
  {
    const auto add = [this](const std::string& name, const std::function<void(Points&)>& smooth) {
      m_settings.push_back({name, smooth, {}, {}});
    };
    for (const unsigned int steps : {1u, 2u, 3u, 4u, 5u, 6u, 8u, 12u})
      add("steps: " + std::to_string(steps), [steps](Points& points) {
        CGAL::balanced_flow_smooth_point_set<CGAL::Sequential_tag>(
            points, CGAL::parameters::number_of_iterations(steps));
      });
    for (const double length : {.5, 1.})
      add("steps: 5 of length " + std::string(length == 1. ? "1" : "0.5"),
          [length](Points& points) {
            CGAL::balanced_flow_smooth_point_set<CGAL::Sequential_tag>(
                points, CGAL::parameters::step_length(length));
          });
    for (const unsigned int percent : {40u, 60u, 80u, 100u, 150u})
      add("neighbors: " + std::to_string(percent) + "%, given as k", [percent](Points& points) {
        const auto scale =
            CGAL::Point_set_flow::estimate_point_set_scale<CGAL::Sequential_tag>(points);
        CGAL::balanced_flow_smooth_point_set<CGAL::Sequential_tag>(points, scale.k * percent / 100);
      });
  }

  void add(const Points& noisy, const Surface& surface, const std::string& name)
  {
    const auto rms = [&](const Points& points) {
      return Surface_errors(points, surface, std::vector<char>(points.size(), false)).all.rms();
    };
    Points by_jet = noisy;
    const double seconds = measure(
        [](Points& points) { CGAL::jet_smooth_point_set<CGAL::Sequential_tag>(points, 24); },
        by_jet);
    const double error = rms(by_jet);
    for (Setting& setting : m_settings) {
      Points smoothed = noisy;
      setting.times.add(measure(setting.smooth, smoothed) / seconds, name);
      setting.errors.add(rms(smoothed) / error, name);
    }
  }

  void print() const
  {
    std::printf("\n## Accuracy over time\n\n| setting | time to jet, k=24 | rms error to jet, k=24 "
                "| cases |\n|---|---|---|---|\n");
    for (const Setting& setting : m_settings)
      std::printf("| %s | %.3f | %.3f | %zu |\n", setting.name.c_str(), setting.times.mean(),
                  setting.errors.mean(), setting.errors.size());
    std::fflush(stdout);
  }
};

} // namespace comparison

#endif // POINT_SET_FLOW_BENCHMARK_COST_CURVE_H
