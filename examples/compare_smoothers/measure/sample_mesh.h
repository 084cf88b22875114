// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef COMPARISON_SAMPLE_MESH_H
#define COMPARISON_SAMPLE_MESH_H

#include "Mesh_surface.h"

#include <cstddef>
#include <functional>

namespace comparison {

/// Uniform density
inline double constant_density(const Point_3&) { return 1.; }

/// n points on a mesh with blue noise, in random order: from five times as many random ones, those
/// with the nearest neighbors are taken out one by one (Yuksel, Sample elimination for generating
/// Poisson disk sample sets, 2015). The density is relative, between 0 and 1.
Samples sample_mesh(const Mesh_surface& surface, std::size_t n, unsigned int seed,
                    const std::function<double(const Point_3&)>& density = constant_density);

} // namespace comparison

#endif // COMPARISON_SAMPLE_MESH_H
