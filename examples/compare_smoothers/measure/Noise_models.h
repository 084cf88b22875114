// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef COMPARISON_NOISE_MODELS_H
#define COMPARISON_NOISE_MODELS_H

#include "Surface.h"

#include <cmath>
#include <random>
#include <string>

namespace comparison {

/// Noisy points, and which of them are not outliers
struct Noisy_points {
  Points points;
  std::vector<char> inlier;
};

/// What belongs to the points that are not outliers
template <typename T>
std::vector<T> inliers(const Noisy_points& noisy, const std::vector<T>& all)
{
  std::vector<T> kept;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (noisy.inlier[i])
      kept.push_back(all[i]);
  return kept;
}

/// The noise of one coordinate with standard deviation 1
inline double unit_noise(const std::string& model, std::mt19937& random)
{
  if (model == "uniform")
    return std::uniform_real_distribution<double>(-std::sqrt(3.), std::sqrt(3.))(random);
  if (model == "Laplace") { // the difference of two exponential variables, each of variance 1/2
    std::exponential_distribution<double> exponential(std::sqrt(2.));
    const double a = exponential(random);
    return a - exponential(random);
  }
  return std::normal_distribution<double>()(random);
}

/// Noise of standard deviation sigma in each coordinate:
/// - uniform, Laplace: the same everywhere; and so is Gaussian, which all other names stand for
/// - directional: along one viewing direction only, as of a scanner
/// - varying: Gaussian, from sigma/2 on one side of the shape to 2 sigma on the other
/// - outliers: Gaussian, and 2% of the points lie up to 0.1 away, in any direction
inline Noisy_points add_noise(const Points& clean, const std::string& model, double sigma,
                              unsigned int seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0., 1.);
  const Vector_3 view(1. / std::sqrt(14.), 2. / std::sqrt(14.), 3. / std::sqrt(14.));
  Noisy_points noisy{{}, std::vector<char>(clean.size(), true)};
  for (const Point_3& p : clean) {
    const double local = model == "varying" ? sigma * std::pow(2., p.x()) : sigma;
    const double x = unit_noise(model, random), y = unit_noise(model, random),
                 z = unit_noise(model, random);
    Vector_3 offset = model == "directional" ? local * x * view : local * Vector_3(x, y, z);
    if (model == "outliers" && unit(random) < .02) {
      noisy.inlier[noisy.points.size()] = false;
      const Vector_3 direction{unit_noise("", random), unit_noise("", random),
                               unit_noise("", random)};
      offset += .1 * unit(random) / std::sqrt(direction.squared_length()) * direction;
    }
    noisy.points.push_back(p + offset);
  }
  return noisy;
}

/// The relative density of samples that vary tenfold over the shape
inline double tenfold_density(const Point_3& p) { return std::pow(10., -.5 * (1. + p.y())); }

} // namespace comparison

#endif // COMPARISON_NOISE_MODELS_H
