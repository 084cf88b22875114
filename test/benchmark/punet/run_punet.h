// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_BENCHMARK_RUN_PUNET_H
#define POINT_SET_FLOW_BENCHMARK_RUN_PUNET_H

#include "Punet_case.h"
#include "field/Comparison.h"

namespace comparison {

/// CD and P2M of all that is compared, per shape and in the mean of the shapes.
class Punet_table {
  enum Column { noisy, jets, bilaterals, ours, ours_best_k, noise_given, normals_given, columns };
  typedef std::array<Punet_score, columns> Row;

  std::string m_group; // the rows that belong to one mean
  Row m_sum;
  std::size_t m_rows = 0;
  Ratios m_cd_to_input, m_p2m_to_input, m_to_best_k, m_thin_to_best_k;

  static void keep_better(Punet_score& best, const Punet_score& score)
  {
    if (score.p2m < best.p2m)
      best = score;
  }

  static Points smooth_with_noise(const Punet_case& c)
  {
    Points points = c.noisy;
    CGAL::balanced_flow_smooth_point_set<Concurrency_tag>(
        points, CGAL::parameters::noise(std::stod(c.noise)));
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

  static Row measure(const Punet_case& c)
  {
    Row row;
    row[noisy] = c.score(c.noisy, "");
    for (const unsigned int k : {12u, 24u, 48u})
      keep_better(row[jets], c.score(jet(c.noisy, k).points, "k=" + std::to_string(k)));
    const Numbered_points oriented = with_normals<Concurrency_tag>(c.noisy, true);
    for (const unsigned int k : {24u, 48u})
      keep_better(row[bilaterals],
                  c.score(bilateral(oriented, k).points, "k=" + std::to_string(k)));
    row[ours] = c.score(point_set_flow(c.noisy).points, "");
    for (const unsigned int k : {8u, 12u, 16u, 24u, 48u})
      keep_better(row[ours_best_k],
                  c.score(point_set_flow(c.noisy, k).points, "k=" + std::to_string(k)));
    row[noise_given] = c.score(smooth_with_noise(c), "");
    row[normals_given] = c.score(smooth_with_true_normals(c), "");
    return row;
  }

  static void print_row(const std::string& name, const Row& row)
  {
    std::printf("| %s |", name.c_str());
    for (const Punet_score& s : row) {
      std::printf(" %.2f / %.2f", s.cd, s.p2m);
      std::printf(s.setting.empty() ? " |" : " (%s) |", s.setting.c_str());
    }
    std::printf(" %.2f / %.2f | **%.2f** |\n", row[ours].cd / row[noisy].cd,
                row[ours].p2m / row[noisy].p2m, row[ours].p2m / row[ours_best_k].p2m);
    std::fflush(stdout);
  }

  void print_mean()
  {
    if (m_rows == 0)
      return;
    for (Punet_score& s : m_sum) {
      s.cd /= double(m_rows);
      s.p2m /= double(m_rows);
    }
    print_row("*mean, " + m_group + "*", m_sum);
    m_rows = 0;
  }

public:
  Punet_table()
  {
    std::printf("\n## PU-Net's test set\n\nCD / two-way P2M, x 1e4\n\n| shape | noisy | jet | "
                "bilateral | ours | ours, best k | ours, noise given | ours, normals given | "
                "ours/noisy | P2M, "
                "ours/best k |\n|---|---|---|---|---|---|---|---|---|---|\n");
  }
  void add(const Punet_case& c)
  {
    const std::string group = std::to_string(c.n) + ", " + c.noise;
    if (group != m_group)
      print_mean();
    m_group = group;
    const Row row = measure(c);
    const std::string name = c.shape + ", " + group;
    print_row(name, row);
    if (m_rows == 0)
      m_sum.fill({0., 0., ""});
    for (std::size_t i = 0; i < columns; ++i) {
      m_sum[i].cd += row[i].cd;
      m_sum[i].p2m += row[i].p2m;
    }
    ++m_rows;
    m_cd_to_input.add(row[ours].cd / row[noisy].cd, name);
    m_p2m_to_input.add(row[ours].p2m / row[noisy].p2m, name);
    const double to_best_k = row[ours].p2m / row[ours_best_k].p2m;
    m_to_best_k.add(to_best_k, name);
    if ((c.shape == "casting" || c.shape == "chair") && c.n == 10000 && c.noise != "0.03")
      m_thin_to_best_k.add(to_best_k, name);
  }
  void finish(Targets& targets)
  {
    print_mean();
    targets.all_at_most(1.05, 5, "P2M to that with the best single k, thin walls",
                        m_thin_to_best_k);
    targets.all_at_most(1.05, 5, "P2M to that with the best single k, all shapes", m_to_best_k);
    targets.all_at_most(1., 5, "CD to that of the input", m_cd_to_input);
    targets.all_at_most(1., 5, "P2M to that of the input", m_p2m_to_input);
  }
};

inline void run_punet(const std::string& folder, const std::vector<std::size_t>& points,
                      Targets& targets)
{
  Punet_table table;
  for_each_punet_case(folder, points, [&](const Punet_case& c) { table.add(c); });
  table.finish(targets);
}

} // namespace comparison

#endif // POINT_SET_FLOW_BENCHMARK_RUN_PUNET_H
