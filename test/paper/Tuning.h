// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_PAPER_TUNING_H
#define POINT_SET_FLOW_PAPER_TUNING_H

#include "Paper_flow.h"

#include <limits>

namespace comparison {

/// The value of a parameter with which the error was least, and the points then. The paper's authors chose
/// their parameters by eye for each model; here the truth is asked, for all compared methods alike.
struct Tuned {
  double value = 0.;
  Points points;

  template <typename Run, typename Error>
  Tuned(const std::vector<double>& values, const Run& run, const Error& error)
  {
    double least = std::numeric_limits<double>::infinity();
    for (const double v : values) {
      Points candidate = run(v);
      const double e = error(candidate);
      if (e < least) {
        least = e;
        value = v;
        points.swap(candidate);
      }
    }
  }
};

/// Surface variations at which g may be 1/2, from K = 40,000 to 9
inline const std::vector<double> half_variations = {.005, .01, .02, .04, .08, .16, .33};
/// Factors on sigma_s of the bilateral filters
inline const std::vector<double> influences = {.25, .5, 1., 2., 4.};

/// A flow with a diffusivity of its own, 1/2 at a variation
inline Paper_flow with_half_at(const Paper_flow& flow, double variation)
{
  using namespace CGAL::Point_set_flow;
  const Diffusivity own = Diffusivity::half_at(variation);
  return [=](const Flow_point_3& u, const Diffusivity&) { return flow(u, own); };
}

/// `run_flow()` with the K that the truth likes best
template <typename Error>
Tuned run_tuned_flow(const Points& noisy, const Paper_flow& flow, const Flow_settings& s,
                     const Error& error)
{
  return {half_variations,
          [&](double variation) { return run_flow(noisy, with_half_at(flow, variation), s); },
          error};
}

} // namespace comparison

#endif // POINT_SET_FLOW_PAPER_TUNING_H
