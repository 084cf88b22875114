// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_BENCHMARK_TRAINING_CLOUDS_H
#define POINT_SET_FLOW_BENCHMARK_TRAINING_CLOUDS_H

#include "random_shapes.h"

#include "measure/Noise_models.h"
#include "measure/sample_mesh.h"

#include <cstdio>
#include <fstream>
#include <random>
#include <string>

namespace comparison {

/// Meshes of CGAL's data to learn from. None of them is a shape of the benchmarks but armadillo, pig, elk and
/// anchor_dense, which are tuned shapes there.
inline Names training_meshes()
{
  return {"3torus",
          "armadillo",
          "pig",
          "elk",
          "anchor_dense",
          "lion-head",
          "man",
          "mannequin-devil",
          "nefertiti",
          "pinion",
          "dragknob",
          "itemb",
          "mushroom",
          "pipe",
          "tripod",
          "helmet",
          "head",
          "bear",
          "bones",
          "diplodocus",
          "ChineseDragon-10kv",
          "bunny00",
          "eight",
          "double-torus-example",
          "mech-holes-shark",
          "part",
          "oblong",
          "cactus",
          "beam",
          "cheese",
          "handle",
          "retinal",
          "cross",
          "ellipsoid",
          "boeing",
          "anchor"};
}

/// Independent points on a surface: uneven by chance, as blue noise is not
/// \param is_wanted tells where there may be points
template <typename Is_wanted>
Points random_points(const Mesh_surface& surface, std::size_t n, std::mt19937& random,
                     const Is_wanted& is_wanted)
{
  std::uniform_real_distribution<double> unit(0., 1.);
  std::discrete_distribution<unsigned int> random_face(surface.face_areas().begin(),
                                                       surface.face_areas().end());
  Points points;
  while (points.size() < n) {
    const std::array<Point_3, 3> corners = surface.triangle(Mesh::Face_index(random_face(random)));
    const double r = std::sqrt(unit(random)), s = unit(random);
    const Point_3 p =
        corners[0] + r * (1. - s) * (corners[1] - corners[0]) + r * s * (corners[2] - corners[0]);
    if (is_wanted(p))
      points.push_back(p);
  }
  return points;
}

/// Points in lines that are some spacings apart, as of a laser
inline Points scan_lines(const Mesh_surface& surface, std::size_t n, double gap,
                         std::mt19937& random)
{
  std::normal_distribution<double> normal;
  Vector_3 across(normal(random), normal(random), normal(random));
  across = across / (gap * std::sqrt(across.squared_length()));
  return random_points(surface, n, random, [&](const Point_3& p) {
    const double x = (p - CGAL::ORIGIN) * across;
    return std::abs(x - std::round(x)) < .02;
  });
}

/// Rounds one coordinate, as file formats and cameras do.
inline void round_along(Points& points, double step, std::mt19937& random)
{
  std::normal_distribution<double> normal;
  Vector_3 direction(normal(random), normal(random), normal(random));
  direction = direction / std::sqrt(direction.squared_length());
  for (Point_3& p : points) {
    const double x = (p - CGAL::ORIGIN) * direction;
    p = p + (std::round(x / step) * step - x) * direction;
  }
}

/// Moves each point with one of some scans, as a registration error does: by `error` in a random direction.
inline void misalign(Points& points, double error, std::mt19937& random)
{
  std::normal_distribution<double> normal;
  std::vector<Vector_3> offsets(std::uniform_int_distribution<std::size_t>(2, 4)(random));
  for (Vector_3& offset : offsets) {
    offset = Vector_3(normal(random), normal(random), normal(random));
    offset = offset * (error / std::sqrt(offset.squared_length()));
  }
  std::uniform_int_distribution<std::size_t> scan(0, offsets.size() - 1);
  for (Point_3& p : points)
    p = p + offsets[scan(random)];
}

/// Noisy points on a surface
struct Training_cloud {
  std::string name;
  std::unique_ptr<const Mesh_surface> surface;
  Points points;
  std::vector<char> inlier;
};

/// The cloud of a number: shape, size, noise and sampling are drawn at random.
/// \param misaligned whether some consist of scans that do not meet: no correction can bring these together
inline Training_cloud training_cloud(unsigned int seed, bool misaligned)
{
  std::mt19937 random(seed * 7919u + 17u);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  Training_cloud cloud;
  const Names meshes = training_meshes();
  const std::size_t n = std::size_t(std::pow(10., uniform(3.5, 4.5)));
  if (uniform(0., 1.) < .6) {
    cloud.name = meshes[std::uniform_int_distribution<std::size_t>(0, meshes.size() - 1)(random)];
    cloud.surface = load_shape(cloud.name, n);
  }
  else {
    cloud.name = "generated";
    std::optional<Mesh> mesh = Random_shapes(random)();
    if (mesh)
      cloud.surface = std::make_unique<Mesh_surface>(std::move(*mesh));
  }
  if (!cloud.surface)
    return cloud;
  const double spacing = std::sqrt(cloud.surface->area() / double(n)), way = uniform(0., 1.);
  const auto anywhere = [](const Point_3&) { return true; };
  const Points clean = way < .1 ? scan_lines(*cloud.surface, n, uniform(1.5, 5.) * spacing, random)
                       : way < .35 ? random_points(*cloud.surface, n, random, anywhere)
                       : way < .5  ? sample_mesh(*cloud.surface, n, seed, tenfold_density).points
                                   : sample_mesh(*cloud.surface, n, seed).points;
  const double share = uniform(0., 1.);
  const double which = uniform(0., 1.);
  const std::string model = which < .48   ? "Gaussian"
                            : which < .66 ? "uniform"
                            : which < .73 ? "Laplace"
                            : which < .83 ? "directional"
                            : which < .92 ? "varying"
                                          : "outliers";
  const double noise = share < .07 ? uniform(0., .06) : std::pow(10., uniform(-1.4, .45));
  const double sigma = model == "directional" ? 1.7 * noise * spacing : noise * spacing;
  Noisy_points noisy = add_noise(clean, model, sigma, seed + 1);
  cloud.points = std::move(noisy.points);
  if (misaligned && uniform(0., 1.) < .1)
    misalign(cloud.points, std::pow(10., uniform(-.3, .6)) * sigma, random);
  if (uniform(0., 1.) < .07)
    round_along(cloud.points, uniform(.1, 3.) * sigma, random);
  cloud.inlier = std::move(noisy.inlier);
  cloud.name += ", " + model + ", " + std::to_string(noise) + ", " + std::to_string(n);
  return cloud;
}

/// Adds all that a network sees of a point.
/// \tparam Input a `Network_input`
template <typename Input>
void append(std::vector<float>& numbers, const Input& x)
{
  numbers.insert(numbers.end(), x.of_point_even.data(), x.of_point_even.data() + Input::point_even);
  numbers.insert(numbers.end(), x.of_point_odd.data(), x.of_point_odd.data() + Input::point_odd);
  for (const auto& lanes : x.even)
    numbers.insert(numbers.end(), lanes.front().data(), lanes.front().data() + Input::most);
  for (const auto& lanes : x.odd)
    numbers.insert(numbers.end(), lanes.front().data(), lanes.front().data() + Input::most);
}

/// Calls `visit(seed, cloud, out)` for the clouds that the arguments of a program name: the file for the output, and
/// the first number and the one after the last.
/// \param misaligned see `training_cloud()`
template <typename Visit>
int for_each_training_cloud(int argc, char** argv, bool misaligned, const Visit& visit)
{
  if (argc != 4) {
    std::fprintf(stderr, "usage: %s OUT FIRST LAST\n", argv[0]);
    return 1;
  }
  std::ofstream out(argv[1], std::ios::binary);
  const auto last = static_cast<unsigned int>(std::stoul(argv[3]));
  for (auto seed = static_cast<unsigned int>(std::stoul(argv[2])); seed < last; ++seed) {
    const Training_cloud cloud = training_cloud(seed, misaligned);
    if (cloud.surface)
      visit(seed, cloud, out);
    std::fflush(stdout);
  }
  return out.flush() ? 0 : 1;
}

} // namespace comparison

#endif // POINT_SET_FLOW_BENCHMARK_TRAINING_CLOUDS_H
