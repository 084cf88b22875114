// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_BENCHMARK_ACCURACY_CASE_H
#define POINT_SET_FLOW_BENCHMARK_ACCURACY_CASE_H

#include "Peers.h"

#include "measure/Noise_models.h"

#include <CGAL/jet_estimate_normals.h>

#include <map>

namespace comparison {

/// Samples of a shape with noise
struct Accuracy_case {
  std::string group, shape, condition;
  std::size_t n;
  double noise; ///< in percent of the radius
  unsigned int seed;

  std::string name() const
  {
    std::ostringstream out;
    out << shape << (condition == "Gaussian" ? "" : " " + condition) << ", " << noise << "%, " << n;
    return out.str();
  }
};

/// Measures of one smoother
struct Score {
  std::string setting = "failed";
  double rms = std::numeric_limits<double>::infinity(), edge_rms = rms;
  double mean = 0.; ///< signed
  double drift = 0., chamfer = 0.;
};

/// What came of a case: for jet, bilateral and APSS the setting with the least rms error, as an
/// oracle would choose it
struct Outcome {
  Accuracy_case what;
  double noisy_rms = 0.;
  double edge_share = 0.; ///< of the points that sharp edges are near to
  double thin_share = 0.; ///< of the points whose opposite sheet is nearer than two deviations
  std::map<std::string, Score> best;
  double best_edge_rms = std::numeric_limits<double>::infinity(); ///< of all settings of CGAL's
  std::vector<double> normal_errors; ///< ours; PCA, jet of the noisy points; of the best peer's

  const Score& ours() const { return best.at("ours"); }
  const Score& peer() const
  {
    const Score &jet = best.at("jet"), &bilateral = best.at("bilateral");
    return jet.rms < bilateral.rms ? jet : bilateral;
  }
  double ratio() const { return ours().rms / peer().rms; }
  double ratio_with_apss() const
  {
    return ours().rms / (std::min)(peer().rms, best.at("APSS").rms);
  }
  /// NaN where hardly any or nearly all points are near edges: there is nothing to compare
  double edge_ratio() const
  {
    return edge_share > .02 && edge_share < .9 ? ours().edge_rms / best_edge_rms : unknown;
  }
  /// What is below a tenth of the noise is as good as none
  double collapse_ratio() const
  {
    return std::abs(ours().mean) / (std::max)(std::abs(peer().mean), what.noise / 1000.);
  }
  double drift_ratio() const
  {
    return ours().drift / (std::min)(best.at("jet").drift, best.at("bilateral").drift);
  }
};

/// The share of samples with an opposite sheet closer than `thickness` behind them
inline double share_of_thin(const Samples& clean, double thickness)
{
  const Nearest_points nearest(clean.points);
  std::size_t thin = 0;
  for (std::size_t i = 0; i < clean.points.size(); ++i)
    for (const auto& neighbor : nearest(clean.points[i], 100)) {
      const Vector_3 d = clean.points[i] - clean.points[neighbor.first];
      const double depth = d * clean.normals[i];
      if (clean.normals[i] * clean.normals[neighbor.first] < -.7 && depth >= 0. &&
          depth < thickness) {
        ++thin;
        break;
      }
    }
  return double(thin) / double(clean.points.size());
}

inline Vectors jet_normals(const Points& points)
{
  Numbered_points numbered;
  for (const Point_3& p : points)
    numbered.emplace_back(p, CGAL::NULL_VECTOR, numbered.size());
  CGAL::jet_estimate_normals<Concurrency_tag>(numbered, 18, numbered_point_maps());
  return normals_in_order(numbered);
}

inline double normal_error_of(const Points& points, const Vectors& normals, const Surface& surface)
{
  Vectors true_normals;
  for (const Point_3& p : points)
    true_normals.push_back(surface.closest(p).normal);
  return normal_error(normals, true_normals);
}

/// Smooths with everything and measures. The samples have their marks near edges.
inline Outcome run_case(const Accuracy_case& what, const Surface& surface, const Samples& clean,
                        bool with_normal_errors)
{
  const double sigma = what.noise / 100.;
  const Noisy_points noisy = add_noise(clean.points, what.condition, sigma, what.seed);
  Outcome outcome;
  outcome.what = what;
  const auto errors_of = [&](const Points& points) {
    return Surface_errors(inliers(noisy, points), surface, inliers(noisy, clean.near_edge));
  };
  outcome.noisy_rms = errors_of(noisy.points).all.rms();
  outcome.edge_share =
      double(std::count(clean.near_edge.begin(), clean.near_edge.end(), true)) / double(what.n);
  outcome.thin_share = what.group == "thin" ? share_of_thin(clean, 2. * sigma) : 0.;

  std::vector<Peer> methods = run_peers(noisy.points);
  add_peer(methods, "ours", "defaults", [&]() { return point_set_flow(noisy.points); });
  std::map<std::string, const Smoothed*> best_smoothed;
  for (const char* family : {"jet", "bilateral", "APSS", "ours"})
    outcome.best[family] = Score();
  for (const Peer& method : methods) {
    const Surface_errors errors = errors_of(method.smoothed.points);
    if (method.family == "jet" || method.family == "bilateral")
      outcome.best_edge_rms = (std::min)(outcome.best_edge_rms, errors.near_edges.rms());
    Score& score = outcome.best[method.family];
    if (errors.all.rms() < score.rms) {
      score = {method.setting, errors.all.rms(), errors.near_edges.rms(), errors.all.mean()};
      best_smoothed[method.family] = &method.smoothed;
    }
  }
  for (const auto& [family, smoothed] : best_smoothed) {
    outcome.best[family].drift =
        tangential_drift(inliers(noisy, noisy.points), inliers(noisy, smoothed->points),
                         inliers(noisy, clean.normals));
    outcome.best[family].chamfer =
        chamfer_distance(inliers(noisy, smoothed->points), inliers(noisy, clean.points));
  }

  if (with_normal_errors && best_smoothed.count("ours")) {
    const Smoothed& ours = *best_smoothed["ours"];
    const bool jet_is_best = outcome.best["jet"].rms < outcome.best["bilateral"].rms;
    const Points& peer = best_smoothed.at(jet_is_best ? "jet" : "bilateral")->points;
    outcome.normal_errors = {normal_error_of(ours.points, ours.normals, surface),
                             normal_error_of(noisy.points, pca_normals(noisy.points), surface),
                             normal_error_of(noisy.points, jet_normals(noisy.points), surface),
                             normal_error_of(peer, pca_normals(peer), surface),
                             normal_error_of(peer, jet_normals(peer), surface)};
  }
  return outcome;
}

} // namespace comparison

#endif // POINT_SET_FLOW_BENCHMARK_ACCURACY_CASE_H
