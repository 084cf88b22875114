// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_BENCHMARK_PUBLISHED_SCORES_H
#define POINT_SET_FLOW_BENCHMARK_PUBLISHED_SCORES_H

#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace comparison {

/// The cases of PU-Net's test set that papers report
struct Punet_group {
  std::size_t n;
  std::string noise; ///< of the radius, as the files have it

  std::string name() const { return std::to_string(n) + ", " + noise; }
  bool operator==(const Punet_group& other) const { return n == other.n && noise == other.noise; }
};

inline const std::array<Punet_group, 6>& punet_groups()
{
  static const std::array<Punet_group, 6> groups = {{{10000, "0.01"},
                                                     {10000, "0.02"},
                                                     {10000, "0.03"},
                                                     {50000, "0.01"},
                                                     {50000, "0.02"},
                                                     {50000, "0.03"}}};
  return groups;
}

/// CD and P2M x 1e4 in the six groups; NaN where nothing was reported
struct Published_row {
  const char* method;
  std::array<std::array<double, 2>, 6> scores;
};

/// Means over the twenty shapes, as papers report them.
inline const std::vector<Published_row>& published_rows()
{
  static const double none = std::nan("");
  static const std::vector<Published_row> rows = {
      {"GLR", {{{2.96, 1.05}, {3.77, 1.31}, {4.91, 2.11}, {.70, .16}, {1.59, .83}, {3.84, 2.71}}}},
      {"score-based",
       {{{2.52, .46}, {3.69, 1.07}, {4.71, 1.94}, {.72, .15}, {1.29, .57}, {1.93, 1.04}}}},
      {"PD-Flow",
       {{{2.13, .38}, {3.25, 1.01}, {5.19, 2.52}, {.65, .16}, {1.42, .78}, {3.90, 2.86}}}},
      {"IterativePFN",
       {{{2.31, .37}, {3.43, .90}, {5.24, 2.50}, {.66, .12}, {1.05, .43}, {2.54, 1.65}}}},
      {"P2P-Bridge",
       {{{2.28, .39}, {3.20, .81}, {3.99, 1.42}, {.59, .09}, {.90, .32}, {1.56, .84}}}},
      {"DSNet",
       {{{1.83, none}, {none, none}, {none, none}, {.60, none}, {none, none}, {none, none}}}}};
  return rows;
}

inline void print_published_head()
{
  std::printf(
      "\n### Beside published figures\n\nCD / P2M, x 1e4, means of the shapes\n\n| method |");
  for (const Punet_group& group : punet_groups())
    std::printf(" %s |", group.name().c_str());
  std::printf("\n|---|---|---|---|---|---|---|\n");
}

inline void print_published_cell(double cd, double p2m)
{
  if (std::isnan(cd))
    std::printf(" - |");
  else if (std::isnan(p2m))
    std::printf(" %.2f / - |", cd);
  else
    std::printf(" %.2f / %.2f |", cd, p2m);
}

inline void print_published_rows()
{
  for (const Published_row& row : published_rows()) {
    std::printf("| %s (published) |", row.method);
    for (const auto& score : row.scores)
      print_published_cell(score[0], score[1]);
    std::printf("\n");
  }
}

/// \param shapes the number of shapes that were measured
inline void print_what_is_comparable(std::size_t shapes)
{
  std::printf("\nWhat is comparable: published figures are means of the twenty shapes of the set, "
              "measured here are %zu. They "
              "come from papers that report each other's methods, and differ between them by a few "
              "hundredths. CD is the same "
              "in all sources. P2M is not: that of the papers depends on the version of PyTorch3D, "
              "in which triangles below a "
              "minimal area count as points, while it is exact here; compare it among the measured "
              "rows only. rms is one-way, "
              "from the points to the mesh, and is not reported by papers.\n",
              shapes);
  std::fflush(stdout);
}

} // namespace comparison

#endif // POINT_SET_FLOW_BENCHMARK_PUBLISHED_SCORES_H
