// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_BENCHMARK_OUTCOME_TABLE_H
#define POINT_SET_FLOW_BENCHMARK_OUTCOME_TABLE_H

#include "Accuracy_case.h"
#include "Targets.h"

#include <fstream>

namespace comparison {

/// Writes outcomes as they come, as rows of Markdown and of CSV.
class Outcome_table {
  std::ofstream m_csv;

  static void print_score(const Score& score)
  {
    std::printf(" %.2f (%s) |", 1e3 * score.rms, score.setting.c_str());
  }

  void write_csv(const Outcome& outcome)
  {
    const Accuracy_case& c = outcome.what;
    m_csv << c.group << ',' << c.shape << ',' << c.condition << ',' << c.n << ',' << c.noise << ','
          << outcome.noisy_rms << ',' << outcome.edge_share << ',' << outcome.thin_share << ','
          << outcome.best_edge_rms;
    for (const auto& [family, s] : outcome.best)
      m_csv << ',' << s.setting << ',' << s.rms << ',' << s.edge_rms << ',' << s.mean << ','
            << s.drift << ',' << s.chamfer;
    m_csv << std::endl;
  }

public:
  explicit Outcome_table(const std::string& csv_file)
  {
    if (csv_file.empty())
      return;
    m_csv.open(csv_file);
    if (!m_csv)
      throw std::runtime_error("cannot write " + csv_file);
    m_csv << "group,shape,condition,points,noise,noisy rms,edge share,thin share,best edge rms";
    for (const char* family : {"APSS", "bilateral", "jet", "ours"}) // the order of a map
      for (const char* measure : {"setting", "rms", "edge rms", "mean", "drift", "chamfer"})
        m_csv << ',' << family << ' ' << measure;
    m_csv << std::endl;
  }

  static void print_header(const std::string& title)
  {
    std::printf("\n## %s\n\n"
                "| shape | points | noise %% | noisy | jet | bilateral | APSS | ours | ratio | "
                "near edges | to best with APSS | mean signed, ours / peer | "
                "drift, ours / jet / bilateral | CD x1e4, ours / peer |\n"
                "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n",
                title.c_str());
    std::fflush(stdout);
  }

  void add(const Outcome& outcome)
  {
    const Accuracy_case& c = outcome.what;
    std::printf("| %s%s%s | %zu | %g | %.2f |", c.shape.c_str(),
                c.condition == "Gaussian" ? "" : " ",
                c.condition == "Gaussian" ? "" : c.condition.c_str(), c.n, c.noise,
                1e3 * outcome.noisy_rms);
    for (const char* family : {"jet", "bilateral", "APSS"})
      print_score(outcome.best.at(family));
    std::printf(" %.2f | **%.2f** |", 1e3 * outcome.ours().rms, outcome.ratio());
    std::printf(std::isnan(outcome.edge_ratio()) ? " - |" : " %.2f |", outcome.edge_ratio());
    std::printf(" %.2f | %.2f / %.2f | %.2f / %.2f / %.2f | %.2f / %.2f |\n",
                outcome.ratio_with_apss(), 1e3 * outcome.ours().mean, 1e3 * outcome.peer().mean,
                1e3 * outcome.ours().drift, 1e3 * outcome.best.at("jet").drift,
                1e3 * outcome.best.at("bilateral").drift, 1e4 * outcome.ours().chamfer,
                1e4 * outcome.peer().chamfer);
    std::fflush(stdout);
    if (m_csv.is_open())
      write_csv(outcome);
  }
};

/// Sorts outcomes into the targets 1 to 5 and 8.
class Outcome_targets {
  typedef std::map<std::string, Ratios> Named_ratios;
  Named_ratios m_rms, m_edges, m_conditions;
  Ratios m_thin, m_collapse, m_drift, m_with_apss, m_noisy_normals, m_smoothed_normals;
  double m_our_means = 0., m_peer_means = 0.;

public:
  void add(const Outcome& outcome)
  {
    const std::string& group = outcome.what.group;
    const std::string name = outcome.what.name();
    const std::string title = group + " shapes, " + std::to_string(outcome.what.n) + " points";
    if (group == "tuned" || group == "untuned") {
      m_rms[title].add(outcome.ratio(), name);
      m_edges[title].add(outcome.edge_ratio(), name);
      m_with_apss.add(outcome.ratio_with_apss(), name);
      m_drift.add(outcome.drift_ratio(), name);
      m_our_means += std::abs(outcome.ours().mean);
      m_peer_means += std::abs(outcome.peer().mean);
    }
    else if (group == "thin" && outcome.thin_share < .05)
      m_thin.add(outcome.ratio(), name);
    else if (group == "thin")
      m_collapse.add(outcome.collapse_ratio(), name);
    else if (group == "conditions")
      m_conditions[outcome.what.condition].add(outcome.ratio(), name);
    if (outcome.normal_errors.size() == 5) {
      const std::vector<double>& e = outcome.normal_errors;
      m_noisy_normals.add(e[0] / (std::min)(e[1], e[2]), name);
      m_smoothed_normals.add(e[0] / (std::min)(e[3], e[4]), name);
    }
  }

  void write_to(Targets& targets) const
  {
    for (const auto& [title, ratios] : m_rms)
      targets.mean_at_most(title.find("untuned") == 0            ? .78
                           : title.find(" 50000 ") != title.npos ? .68
                                                                 : .74,
                           1, "rms to best peer, " + title, ratios);
    for (const auto& [title, ratios] : m_edges)
      targets.mean_at_most(.85, 1, "rms near edges to best peer, " + title, ratios);
    targets.all_at_most(1., 2, "rms to best peer, thin parts, sheets two deviations apart", m_thin);
    targets.all_at_most(1., 2, "mean signed distance to best peer's, thinner parts", m_collapse);
    if (m_peer_means > 0.) {
      Ratios means;
      means.add(m_our_means / m_peer_means, "sum over all");
      targets.mean_at_most(.5, 3, "mean signed distance to best peer's", means);
    }
    targets.all_at_most(1., 3, "tangential drift to the lesser of jet's and bilateral's", m_drift);
    targets.mean_at_most(.9, 4, "rms to the best of peers and APSS", m_with_apss);
    for (const auto& [condition, ratios] : m_conditions)
      targets.all_at_most(1.05, 5, "rms to best peer, " + condition, ratios);
    targets.all_at_most(1., 8, "normal error to PCA's and jet's of noisy points", m_noisy_normals);
    targets.all_at_most(1., 8, "normal error to PCA's and jet's of the best peer's points",
                        m_smoothed_normals);
  }
};

} // namespace comparison

#endif // POINT_SET_FLOW_BENCHMARK_OUTCOME_TABLE_H
