// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_BENCHMARK_PEERS_H
#define POINT_SET_FLOW_BENCHMARK_PEERS_H

#include "Apss.h"

#include "measure/Smoothing_measures.h"

#include <string>

namespace comparison {

/// What others make of the same points, with each of their settings.
struct Peer {
  std::string family, setting;
  Smoothed smoothed;
};

/// Adds what a peer makes of the points, unless it fails
template <typename Smooth>
void add_peer(std::vector<Peer>& peers, const char* family, const std::string& setting,
              const Smooth& smooth)
{
  try {
    Smoothed smoothed = smooth();
    if (all_finite(smoothed.points)) {
      peers.push_back({family, setting, std::move(smoothed)});
      return;
    }
  }
  catch (const std::exception&) {
  }
  std::cerr << "warning: " << family << ", " << setting << " failed" << std::endl;
}

inline void add_jets(std::vector<Peer>& peers, const Points& noisy)
{
  for (const unsigned int k : {12u, 24u, 48u})
    add_peer(peers, "jet", "k=" + std::to_string(k), [&]() { return jet(noisy, k); });
}

/// CGAL's smoothers, the bilateral one with the normals of the points.
inline std::vector<Peer> run_cgal_peers(const Points& noisy, const Numbered_points& oriented)
{
  std::vector<Peer> peers;
  add_jets(peers, noisy);
  add_peer(peers, "jet", "k=24 twice", [&]() { return jet(noisy, 24, 2); });
  for (const unsigned int k : {24u, 48u})
    add_peer(peers, "bilateral", "k=" + std::to_string(k),
             [&]() { return bilateral(oriented, k); });
  add_peer(peers, "bilateral", "k=24 3 times", [&]() { return bilateral(oriented, 24, 3); });
  return peers;
}

/// CGAL's smoothers and APSS, with normals that are estimated once for all.
inline std::vector<Peer> run_peers(const Points& noisy)
{
  const Numbered_points oriented = with_normals<Concurrency_tag>(noisy, true);
  std::vector<Peer> peers = run_cgal_peers(noisy, oriented);
  const Vectors normals = normals_in_order(oriented);
  for (const unsigned int k : {48u, 80u})
    add_peer(peers, "APSS", "k=" + std::to_string(k), [&]() { return apss(noisy, normals, k); });
  add_peer(peers, "APSS", "k=80 twice", [&]() { return apss(noisy, normals, 80, 2); });
  return peers;
}

} // namespace comparison

#endif // POINT_SET_FLOW_BENCHMARK_PEERS_H
