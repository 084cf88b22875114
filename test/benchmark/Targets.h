// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_BENCHMARK_TARGETS_H
#define POINT_SET_FLOW_BENCHMARK_TARGETS_H

#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <string>

namespace comparison {

/// Ratios of cases, their geometric mean and the worst of them.
class Ratios {
  double m_log_sum = 0., m_worst = -std::numeric_limits<double>::infinity();
  std::size_t m_n = 0;
  std::string m_worst_case;

public:
  /// NaN says that the case has nothing to compare
  void add(double ratio, const std::string& name)
  {
    if (std::isnan(ratio))
      return;
    m_log_sum += std::log(ratio);
    ++m_n;
    if (ratio > m_worst) {
      m_worst = ratio;
      m_worst_case = name;
    }
  }
  std::size_t size() const { return m_n; }
  double mean() const { return std::exp(m_log_sum / double(m_n)); }
  double worst() const { return m_worst; }
  const std::string& worst_case() const { return m_worst_case; }
};

/// The table of targets: what is wanted and what was reached.
class Targets {
  std::multimap<int, std::string> m_lines; // by number, in the order in which they came

  void add(int number, const std::string& what, const std::string& wanted, double reached,
           double bound, const Ratios& ratios)
  {
    if (ratios.size() == 0)
      return;
    char line[1024];
    std::snprintf(line, sizeof line, "| %d | %s | %s %.2f | %.3f | %.3f (%s) | %zu | %s |", number,
                  what.c_str(), wanted.c_str(), bound, ratios.mean(), ratios.worst(),
                  ratios.worst_case().c_str(), ratios.size(), reached <= bound ? "yes" : "no");
    m_lines.emplace(number, line);
  }

public:
  void mean_at_most(double bound, int number, const std::string& what, const Ratios& ratios)
  {
    add(number, what, "mean", ratios.mean(), bound, ratios);
  }
  void all_at_most(double bound, int number, const std::string& what, const Ratios& ratios)
  {
    add(number, what, "all", ratios.worst(), bound, ratios);
  }

  void print() const
  {
    std::printf("\n## Targets\n\n| target | measure | at most | geometric mean | worst case | "
                "cases | reached |\n"
                "|---|---|---|---|---|---|---|\n");
    for (const auto& line : m_lines)
      std::printf("%s\n", line.second.c_str());
    std::fflush(stdout);
  }
};

} // namespace comparison

#endif // POINT_SET_FLOW_BENCHMARK_TARGETS_H
