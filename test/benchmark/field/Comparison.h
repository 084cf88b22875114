// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_BENCHMARK_COMPARISON_H
#define POINT_SET_FLOW_BENCHMARK_COMPARISON_H

#include "Peers.h"
#include "Targets.h"
#include "Test_cloud.h"

#include <CGAL/balanced_flow_smooth_point_set.h>

#include <cstdio>

namespace comparison {

/// With its defaults, and the normals and the numbers of the scans that are known; empty if they are not
inline Points smooth_with_layers(Points points, Vectors normals,
                                 const std::vector<unsigned int>& scans = {})
{
  namespace np = CGAL::parameters;
  if (normals.empty())
    return point_set_flow(points).points;
  std::vector<std::size_t> indices = numbers(points.size());
  const auto point_map = CGAL::make_property_map(points);
  const auto normal_map = CGAL::make_property_map(normals);
  const auto scan_map = CGAL::make_property_map(scans);
  if (scans.empty())
    CGAL::balanced_flow_smooth_point_set<Concurrency_tag>(
        indices, np::point_map(point_map).normal_map(normal_map));
  else
    CGAL::balanced_flow_smooth_point_set<Concurrency_tag>(
        indices, np::scan_map(scan_map).point_map(point_map).normal_map(normal_map));
  return points;
}

enum class Rivals { jets, jets_and_bilateral };

/// The error of our defaults beside the least of the others', as an oracle would choose it: of doing
/// nothing, and of CGAL's smoothers.
struct Comparison {
  double raw, best, ours;
  std::string best_setting = "nothing";
  double movement;    ///< ours, rms
  double share_moved; ///< of the points, by ours

  Comparison(const Test_cloud& cloud, Rivals rivals) : raw(cloud.error_of(cloud.points)), best(raw)
  {
    std::vector<Peer> peers;
    if (rivals == Rivals::jets)
      add_jets(peers, cloud.points);
    else
      peers = run_cgal_peers(cloud.points, with_normals<Concurrency_tag>(cloud.points, true));
    for (const Peer& peer : peers) {
      const double error = cloud.error_of(peer.smoothed.points);
      if (error < best) {
        best = error;
        best_setting = peer.family + " " + peer.setting;
      }
    }
    const Points smoothed = smooth_with_layers(cloud.points, cloud.normals, cloud.scans);
    ours = cloud.error_of(smoothed);
    movement = comparison::movement(cloud.points, smoothed);
    share_moved = comparison::share_moved(cloud.points, smoothed);
  }
  double ratio() const { return ours / best; }
};

/// A table of comparisons, rows as they are done.
class Comparison_table {
  Ratios m_ratios;

public:
  explicit Comparison_table(const std::string& title)
  {
    std::printf(
        "\n## %s\n\n| cloud | points | noise in spacings | raw | best of the others | ours | "
        "ours/best | moved |\n|---|---|---|---|---|---|---|---|\n",
        title.c_str());
    std::fflush(stdout);
  }
  /// Lengths in thousandths of `unit`, which need not be the spacing
  void add(const Test_cloud& cloud, const Comparison& c, double unit = 1.)
  {
    const double scale = 1e3 / unit;
    std::printf("| %s | %zu | %.3f | %.2f | %.2f (%s) | %.2f | **%.2f** | %.0f%% |\n",
                cloud.name.c_str(), cloud.points.size(), c.raw / cloud.spacing, scale * c.raw,
                scale * c.best, c.best_setting.c_str(), scale * c.ours, c.ratio(),
                100. * c.share_moved);
    std::fflush(stdout);
    m_ratios.add(c.ratio(), cloud.name + ", " + std::to_string(cloud.points.size()));
  }
  const Ratios& ratios() const { return m_ratios; }
};

} // namespace comparison

#endif // POINT_SET_FLOW_BENCHMARK_COMPARISON_H
