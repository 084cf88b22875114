// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_BENCHMARK_PUNET_TABLE_H
#define POINT_SET_FLOW_BENCHMARK_PUNET_TABLE_H

#include "Punet_case.h"
#include "published_scores.h"

#include <map>

namespace comparison {

/// What was measured of one case, by the names of the columns
typedef std::map<std::string, Punet_score> Punet_row;

/// The scores per shape and in the mean of the shapes, rows as they are done, and the means beside published ones.
class Punet_table {
  struct Mean {
    Punet_score sum = {0., 0., 0., 0., 0., ""};
    std::size_t n = 0;

    Punet_score mean() const
    {
      const double m = double(n);
      return {sum.cd / m, sum.p2m / m, sum.rms / m, sum.variation / m, sum.gap / m, ""};
    }
  };
  typedef std::map<std::string, Mean> Means;

  const std::vector<std::string> m_columns;
  std::map<std::string, Means> m_groups; // by their names
  std::string m_group;                   // the rows that belong to one mean
  std::size_t m_most_shapes = 0;

  void print_row(const std::string& name, const Punet_row& row) const
  {
    std::printf("| %s |", name.c_str());
    for (const std::string& column : m_columns) {
      const auto found = row.find(column);
      if (found == row.end()) {
        std::printf(" - |");
        continue;
      }
      const Punet_score& s = found->second;
      std::printf(" %.2f / %.2f / %.2f (%.2f, %.1f)", s.cd, s.p2m, s.rms, s.variation, s.gap);
      std::printf(s.setting.empty() ? " |" : " %s |", s.setting.c_str());
    }
    std::printf("\n");
    std::fflush(stdout);
  }

  void print_mean()
  {
    if (m_group.empty())
      return;
    Punet_row means;
    std::size_t shapes = 0;
    for (const auto& [column, mean] : m_groups[m_group]) {
      means[column] = mean.mean();
      shapes = (std::max)(shapes, mean.n);
    }
    for (const auto& [column, mean] : m_groups[m_group])
      if (mean.n != shapes) // of others, who have not written all
        means[column].setting = "of " + std::to_string(mean.n);
    print_row("*mean, " + m_group + "*", means);
    m_most_shapes = (std::max)(m_most_shapes, shapes);
  }

public:
  explicit Punet_table(const std::vector<std::string>& columns) : m_columns(columns)
  {
    std::printf("\n## PU-Net's test set\n\nCD / two-way P2M, x 1e4 / rms distance to the mesh, x "
                "1e3 (variation of the "
                "spacing, largest gap in spacings of the clean points), the best setting where "
                "there are several\n\n"
                "| shape |");
    for (const std::string& column : columns)
      std::printf(" %s |", column.c_str());
    std::printf("\n|---|");
    for (std::size_t i = 0; i < columns.size(); ++i)
      std::printf("---|");
    std::printf("\n");
  }

  void add(const Punet_case& c, const Punet_row& row)
  {
    if (c.group.name() != m_group)
      print_mean();
    m_group = c.group.name();
    print_row(c.name(), row);
    for (const auto& [column, score] : row) {
      Mean& mean = m_groups[m_group][column];
      mean.sum.cd += score.cd;
      mean.sum.p2m += score.p2m;
      mean.sum.rms += score.rms;
      mean.sum.variation += score.variation;
      mean.sum.gap += score.gap;
      ++mean.n;
    }
  }

  void finish()
  {
    print_mean();
    print_published_head();
    for (const std::string& column : m_columns) {
      std::printf("| %s |", column.c_str());
      for (const Punet_group& group : punet_groups()) {
        const Mean& mean = m_groups[group.name()][column];
        print_published_cell(mean.mean().cd, mean.mean().p2m); // NaN if there is none
      }
      std::printf("\n");
    }
    print_published_rows();
    print_what_is_comparable(m_most_shapes);
  }
};

} // namespace comparison

#endif // POINT_SET_FLOW_BENCHMARK_PUNET_TABLE_H
