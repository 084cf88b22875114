// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_PAPER_DIFFUSIVITY_FIGURE_H
#define POINT_SET_FLOW_PAPER_DIFFUSIVITY_FIGURE_H

#include "Paper_case.h"
#include "Paper_flow.h"

namespace comparison {

/// Points on a strip over a curve in the plane z = 0, along which there are corners. A curve alone has no surface
/// variation, Eq. (2): its covariance matrix has an eigenvalue of 0.
class Curve_strip {
  std::vector<std::pair<double, double>> m_corners = {{0., 0.},   {1., 0.},   {1., .45}, {1.8, .45},
                                                      {2.2, .85}, {2.6, .45}, {3.8, .45}};
  double m_length = 0.;

public:
  Points points;
  Numbers arc_length, from_corner; // of each point
  std::vector<char> inner;         // whether it is in the middle of the strip

  explicit Curve_strip(double spacing)
  {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> jitter(.1, .9);
    const int width = 24;
    for (std::size_t c = 0; c + 1 < m_corners.size(); ++c) {
      const auto [x, y] = m_corners[c];
      const double dx = m_corners[c + 1].first - x, dy = m_corners[c + 1].second - y;
      const double length = std::hypot(dx, dy);
      const bool is_wave = c + 2 == m_corners.size(); // the last piece is curved, but smooth
      const int n = int(std::lround(length / spacing));
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < width; ++j) {
          const double t = (i + jitter(random)) / n;
          const double wave = is_wave ? .12 * (1. - std::cos(4. * CGAL_PI * t)) : 0.;
          points.emplace_back(x + t * dx, y + t * dy + wave, spacing * (j + jitter(random)));
          arc_length.push_back(m_length + t * length);
          const double to_start = c == 0 ? length : t * length; // the ends are no corners
          from_corner.push_back((std::min)(to_start, is_wave ? length : (1. - t) * length));
          inner.push_back(j >= width / 3 && j < 2 * width / 3 &&
                          at_least_from_ends(t, c, length, spacing));
        }
      m_length += length;
    }
  }

private:
  bool at_least_from_ends(double t, std::size_t piece, double length, double spacing) const
  {
    const double margin = 5. * spacing;
    return !(piece == 0 && t * length < margin) &&
           !(piece + 2 == m_corners.size() && (1. - t) * length < margin);
  }
};

/// How likely a point at a corner has less diffusivity than one far from corners: 1 if g tells all
/// of them apart, 1/2 if it knows nothing
inline double separation(const Numbers& at_corners, Numbers elsewhere)
{
  std::sort(elsewhere.begin(), elsewhere.end());
  double sum = 0.;
  for (const double g : at_corners)
    sum += double(elsewhere.end() - std::upper_bound(elsewhere.begin(), elsewhere.end(), g));
  return sum / (double(at_corners.size()) * double(elsewhere.size()));
}

/// Fig. 3: the diffusivity of a noisy curve, of the noisy surface and of the prefiltered one
inline void diffusivity_figure(const Run_settings& s)
{
  const double spacing = s.quick ? .05 : .02;
  const Curve_strip curve(spacing);
  Points noisy = curve.points;
  noisy = add_noise(noisy, "Gaussian", .35 * spacing, 4).points;
  const std::vector<Seen> clean = what_flows_see(curve.points), narrow = what_flows_see(noisy),
                          wide = what_flows_see(noisy, 20, .6);

  struct Row {
    std::string title;
    std::function<double(std::size_t)> variation;
  };
  const std::vector<Row> rows = {
      {"clean", [&](std::size_t i) { return clean[i].variation; }},
      {"noisy, Eq. (5)", [&](std::size_t i) { return narrow[i].variation; }},
      {"prefiltered, width 0.3, Eq. (6)",
       [&](std::size_t i) { return narrow[i].filtered_variation; }},
      {"prefiltered, width 0.6, Eq. (6)",
       [&](std::size_t i) { return wide[i].filtered_variation; }}};

  Figure figure(s.folder, "fig3");
  Result_table table;
  std::vector<Numbers> lines(curve.points.size());
  for (std::size_t i = 0; i < lines.size(); ++i)
    lines[i] = {noisy[i].x(), noisy[i].y(), curve.arc_length[i], double(curve.inner[i])};
  for (const Row& row : rows) {
    // K is a matter of taste: g is 1/2 in the middle between what is typical far from corners and at them
    Numbers corner_variation, flat_variation;
    for (std::size_t i = 0; i < lines.size(); ++i)
      if (curve.inner[i] && curve.from_corner[i] < spacing)
        corner_variation.push_back(row.variation(i));
      else if (curve.inner[i] && curve.from_corner[i] > 4. * spacing)
        flat_variation.push_back(row.variation(i));
    const auto median = [](Numbers x) {
      const auto middle = x.begin() + std::ptrdiff_t(x.size() / 2);
      std::nth_element(x.begin(), middle, x.end());
      return *middle;
    };
    const auto g = CGAL::Point_set_flow::Diffusivity::half_at(
        .5 * (median(corner_variation) + median(flat_variation)));
    Numbers at_corners, elsewhere;
    for (const double v : corner_variation)
      at_corners.push_back(g(v));
    for (const double v : flat_variation)
      elsewhere.push_back(g(v));
    for (std::size_t i = 0; i < lines.size(); ++i)
      lines[i].push_back(g(row.variation(i)));
    table.add(row.title, {{"median g at corners", median(at_corners)},
                          {"median g elsewhere", median(elsewhere)},
                          {"corner told from elsewhere", separation(at_corners, elsewhere)}});
  }
  figure.write_curves("fig3_curve", lines);
  figure.write_table(table);
}

} // namespace comparison

#endif // POINT_SET_FLOW_PAPER_DIFFUSIVITY_FIGURE_H
