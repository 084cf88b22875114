// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_BENCHMARK_RUN_PUNET_H
#define POINT_SET_FLOW_BENCHMARK_RUN_PUNET_H

#include "Punet_table.h"

#include "field/Comparison.h"

namespace comparison {

/// Ours beside CGAL's smoothers, APSS and what others have written, on PU-Net's test set.
class Punet_benchmark {
  std::vector<std::filesystem::path> m_others; ///< folders, with the names of the methods
  Ratios m_cd_to_input, m_p2m_to_input, m_to_best_k, m_thin_to_best_k, m_relaxed_cd, m_relaxed_p2m;

  static constexpr unsigned int relaxation_steps = 5;

  static void keep_better(Punet_row& row, const std::string& column, const Punet_score& score)
  {
    const auto [found, is_new] = row.emplace(column, score);
    if (!is_new && score.p2m < found->second.p2m)
      found->second = score;
  }

  static Points smooth_with_noise(const Punet_case& c)
  {
    Points points = c.noisy;
    CGAL::balanced_flow_smooth_point_set<Concurrency_tag>(
        points, CGAL::parameters::noise(std::stod(c.group.noise)));
    return points;
  }

  /// With the normals of the mesh: of a scanner that knows its side
  static Points smooth_with_true_normals(const Punet_case& c)
  {
    Points on_mesh = c.noisy;
    c.mesh_sphere.apply(on_mesh);
    Vectors normals;
    for (const Point_3& p : on_mesh)
      normals.push_back(c.surface->closest(p).normal);
    return smooth_with_layers(c.noisy, normals);
  }

  Punet_row measure(const Punet_case& c) const
  {
    Punet_row row;
    row["noisy"] = c.score(c.noisy, "");
    for (const Peer& peer : run_peers(c.noisy))
      keep_better(row, peer.family, c.score(peer.smoothed.points, peer.setting));
    row["ours"] = c.score(point_set_flow(c.noisy).points, "");
    row["ours, relaxed"] = c.score(point_set_flow_relaxed(c.noisy, relaxation_steps).points, "");
    for (const unsigned int k : {8u, 12u, 16u, 24u, 48u})
      keep_better(row, "ours, best k",
                  c.score(point_set_flow(c.noisy, k).points, "k=" + std::to_string(k)));
    row["ours, noise given"] = c.score(smooth_with_noise(c), "");
    row["ours, normals given"] = c.score(smooth_with_true_normals(c), "");
    for (const std::filesystem::path& folder : m_others)
      if (std::filesystem::exists(folder / c.file_name()))
        row[name_of(folder)] = c.score(read_cloud(folder / c.file_name()), "");
    return row;
  }

  static std::string name_of(const std::filesystem::path& folder)
  {
    return (folder.has_filename() ? folder : folder.parent_path()).filename().string();
  }

  void add_ratios(const Punet_case& c, const Punet_row& row)
  {
    const Punet_score &noisy = row.at("noisy"), &ours = row.at("ours"),
                      &relaxed = row.at("ours, relaxed");
    m_cd_to_input.add(ours.cd / noisy.cd, c.name());
    m_p2m_to_input.add(ours.p2m / noisy.p2m, c.name());
    m_relaxed_cd.add(relaxed.cd / ours.cd, c.name());
    m_relaxed_p2m.add(relaxed.p2m / ours.p2m, c.name());
    const double to_best_k = ours.p2m / row.at("ours, best k").p2m;
    m_to_best_k.add(to_best_k, c.name());
    if ((c.shape == "casting" || c.shape == "chair") && c.group.n == 10000 &&
        c.group.noise != "0.03")
      m_thin_to_best_k.add(to_best_k, c.name());
  }

public:
  explicit Punet_benchmark(const std::vector<std::string>& others)
      : m_others(others.begin(), others.end())
  {
    for (const std::filesystem::path& folder : m_others)
      if (!std::filesystem::is_directory(folder))
        throw std::runtime_error(folder.string() + " is no folder");
  }

  void run(const std::string& folder, const std::vector<std::size_t>& points, Targets& targets)
  {
    std::vector<std::string> columns = {"noisy",
                                        "jet",
                                        "bilateral",
                                        "APSS",
                                        "ours",
                                        "ours, relaxed",
                                        "ours, best k",
                                        "ours, noise given",
                                        "ours, normals given"};
    for (const std::filesystem::path& other : m_others)
      columns.push_back(name_of(other));
    Punet_table table(columns);
    for_each_punet_case(folder, points, [&](const Punet_case& c) {
      const Punet_row row = measure(c);
      table.add(c, row);
      add_ratios(c, row);
    });
    table.finish();
    targets.all_at_most(1.05, 5, "P2M to that with the best single k, thin walls",
                        m_thin_to_best_k);
    targets.all_at_most(1.05, 5, "P2M to that with the best single k, all shapes", m_to_best_k);
    targets.all_at_most(1., 5, "CD to that of the input", m_cd_to_input);
    targets.all_at_most(1., 5, "P2M to that of the input", m_p2m_to_input);
    targets.all_at_most(1., 5, "CD relaxed to not relaxed", m_relaxed_cd);
    targets.all_at_most(1.05, 5, "P2M relaxed to not relaxed", m_relaxed_p2m);
  }
};

} // namespace comparison

#endif // POINT_SET_FLOW_BENCHMARK_RUN_PUNET_H
