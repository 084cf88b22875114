// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef COMPARISON_DRAWN_CLOUD_H
#define COMPARISON_DRAWN_CLOUD_H

#include "measure/Surface.h"

#include <cstddef>
#include <vector>

namespace comparison {

/// What a picture shows of a cloud: all of its points, or a random sample of them, and numbers for
/// each. Planes and features are of all points, whatever is drawn, and measured alike in all clouds.
struct Drawn_cloud {
  Points points;
  Vectors normals;                ///< of PCA, on any side
  std::vector<double> variations; ///< of the surface, Eq. (2): 0 in a plane, at most 1/3
  std::vector<double> strengths;  ///< of features, 0 to 1
  std::vector<double> errors;     ///< signed; empty if they are not known
  double spacing = 0.;            ///< median distance to the sixth nearest of the drawn points
};

/// \param errors of all points; empty if they are not known
/// \param most the number of points that are drawn, if there are as many
Drawn_cloud make_drawn_cloud(const Points& points, const std::vector<double>& errors,
                             std::size_t most);

} // namespace comparison

#endif // COMPARISON_DRAWN_CLOUD_H
