// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_BENCHMARK_RUN_FIELD_H
#define POINT_SET_FLOW_BENCHMARK_RUN_FIELD_H

#include "Comparison.h"
#include "field_clouds.h"
#include "uneven_clouds.h"

#include <functional>

namespace comparison {

/// All clouds of the field in one variation
inline std::vector<std::function<Test_cloud()>> field_cloud_makers(const Variation& v)
{
  using namespace field_clouds;
  const Cloud_maker make(v);
  return {[=]() { return airborne(make, .06); },
          [=]() { return airborne(make, .13); },
          [=]() { return dense_beside_sparse(make); },
          [=]() { return object_on_floor(make); },
          [=]() { return merged_twice(make); },
          [=]() { return depth_frames(make); },
          [=]() { return laser_profiles(make); },
          [=]() { return rounded_heights(make); },
          [=]() { return street(make); },
          [=]() { return below_leaves(make); },
          [=]() { return registered_scans(make); }};
}

/// As described; fewer points with more noise on rougher ground; and more points with less noise
inline std::vector<Variation> field_variations(unsigned int seed, bool quick)
{
  if (quick)
    return {{3000, 1., 1., seed}};
  return {{15000, 1., 1., seed}, {6000, 1.4, .6, seed + 100}, {30000, .75, .8, seed + 200}};
}

inline void run_field(unsigned int seed, bool quick, Targets& targets)
{
  Comparison_table table("Clouds from the field");
  for (const Variation& variation : field_variations(seed, quick))
    for (const auto& make : field_cloud_makers(variation)) {
      const Test_cloud cloud = make();
      table.add(cloud, Comparison(cloud, Rivals::jets));
    }
  targets.all_at_most(1., 1, "error to the best of nothing and jets, field", table.ratios());
  targets.mean_at_most(.75, 1, "error to the best of nothing and jets, field", table.ratios());
}

} // namespace comparison

#endif // POINT_SET_FLOW_BENCHMARK_RUN_FIELD_H
