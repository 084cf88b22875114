// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_BENCHMARK_RUN_RELIEF_H
#define POINT_SET_FLOW_BENCHMARK_RUN_RELIEF_H

#include "Building_relief.h"

#include "Peers.h"
#include "Targets.h"
#include "pairs/run_pairs.h"

namespace comparison {

/// CGAL's scan of a building
inline void run_relief(Targets& targets)
{
  const Points noisy = read_cloud(CGAL::data_file_path("points_3/building.ply"));
  const Building_relief relief(noisy);
  const double raw = relief.roughness(noisy);
  std::printf("\n## Relief of a building\n\n%zu points, %zu steps, %zu flat patches; roughness in "
              "the unit of the data"
              "\n\n| smoother | relief kept | in the worst tenth of the steps | roughness | of the "
              "input's |\n|---|---|---|---|---|\n",
              noisy.size(), relief.number_of_steps(), relief.number_of_flat_patches());
  const auto print = [&](const std::string& name, const Points& points) {
    const double roughness = relief.roughness(points);
    const Building_relief::Kept kept = relief.relief_kept(points);
    std::printf("| %s | %.1f%% | %.1f%% | %.4f | %.2f |\n", name.c_str(), 100. * kept.mean,
                100. * kept.worst_tenth, roughness, roughness / raw);
    std::fflush(stdout);
  };
  print("nothing", noisy);
  std::vector<Peer> jets;
  add_jets(jets, noisy);
  for (const Peer& peer : jets)
    print(peer.family + " " + peer.setting, peer.smoothed.points);
  const Points ours = point_set_flow(noisy).points;
  print("ours", ours);
  Ratios lost, roughness;
  lost.add(std::abs(1. - relief.relief_kept(ours).mean), "building");
  roughness.add(relief.roughness(ours) / raw, "building");
  targets.all_at_most(.05, 7, "share of the relief lost", lost);
  targets.all_at_most(.334, 7, "roughness to that of the input", roughness);
}

} // namespace comparison

#endif // POINT_SET_FLOW_BENCHMARK_RUN_RELIEF_H
