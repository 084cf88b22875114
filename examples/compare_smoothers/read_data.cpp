// SPDX-License-Identifier: GPL-3.0-or-later
#include "read_data.h"

#include "measure/Noise_models.h"
#include "measure/Point_surface.h"
#include "measure/sample_mesh.h"

#include <CGAL/IO/read_points.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <iterator>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace comparison {

namespace {

Points read_cloud(const std::string& file)
{
  Points points;
  if (!CGAL::IO::read_points(file, std::back_inserter(points)) || points.size() < 20)
    throw std::runtime_error("cannot read 20 points or more from " + file);
  return points;
}

/// The same points in the same order, with noise and without
Noisy_data read_two_clouds(const std::string& noisy, const std::string& clean, Unit_sphere_map& map)
{
  Noisy_data data;
  data.noisy = read_cloud(noisy);
  data.clean.points = read_cloud(clean);
  if (data.noisy.size() != data.clean.points.size())
    throw std::runtime_error("the two files have different numbers of points");
  map = Unit_sphere_map::of(data.clean.points);
  map.apply(data.noisy);
  map.apply(data.clean.points);
  auto surface = std::make_unique<Point_surface>(data.clean.points);
  data.clean.normals = surface->normals();
  data.clean.near_edge.assign(data.noisy.size(), false);
  data.surface = std::move(surface);
  std::cout << "Truth: the plane of the nearest clean point, with its PCA normal (k=18). Sharp "
               "edges are not known.\n";
  return data;
}

/// Samples of a mesh, to which noise is added
Noisy_data sample(Mesh mesh, const Settings& s)
{
  Noisy_data data;
  auto surface = std::make_unique<Mesh_surface>(std::move(mesh));
  const double sigma = s.noise / 100.;
  data.clean = sample_mesh(*surface, s.n, s.seed);
  data.edge_distance = 2. * std::sqrt(surface->area() / double(s.n)) + 3. * sigma;
  find_samples_near_edges(data.clean, *surface, data.edge_distance);
  data.noisy = add_noise(data.clean.points, "Gaussian", sigma, s.seed + 1).points;
  data.surface = std::move(surface);
  std::cout << "Truth: the mesh. Near its sharp edges (over 30 degrees, closer than "
            << 1e3 * data.edge_distance
            << "): " << std::count(data.clean.near_edge.begin(), data.clean.near_edge.end(), true)
            << " of " << s.n << " points.\n";
  return data;
}

} // namespace

Noisy_data read_data(const Settings& s, Unit_sphere_map& map)
{
  if (s.files.size() == 2)
    return read_two_clouds(s.files[0], s.files[1], map);
  std::optional<Mesh> mesh;
  if (!s.cloud && !(mesh = read_mesh(s.files[0], map))) // of points only, or not of a mesh's format
    std::cout << "No mesh in " << s.files[0] << ": taken as a scan.\n";
  if (mesh)
    return sample(std::move(*mesh), s);
  Noisy_data data;
  data.noisy = read_cloud(s.files[0]);
  map = Unit_sphere_map::of(data.noisy);
  map.apply(data.noisy);
  std::cout << "Truth: not known.\n";
  return data;
}

} // namespace comparison
