// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_TEST_LAYERS_TWO_SHEETS_H
#define POINT_SET_FLOW_TEST_LAYERS_TWO_SHEETS_H

#include "shapes.h"

#include <cmath>
#include <cstddef>
#include <vector>

namespace layers {

using shapes::Points;
typedef std::vector<shapes::Vector_3> Normals;

const shapes::Vector_3 unknown(0., 0., 0.);

const double sigma = .02; // half of the spacing of a sheet

/// Points with normals that are given, and where they would be without noise
struct Scan {
  Points points, truth;
  Normals normals;

  std::size_t size() const { return points.size(); }

  Points smoothed(const Normals& given, unsigned int block_size = 1000000) const;
  Points smoothed_in_parallel(const Normals& given) const;
  Points smoothed_without_normals() const;

  /// The mean of a function of a point and its number, over points of one layer and far from the border
  template <typename Function>
  double mean(const Points& result, bool is_up, const Function& function) const
  {
    double sum = 0., count = 0.;
    for (std::size_t i = 0; i < size(); ++i)
      if ((normals[i].z() > 0.) == is_up && std::abs(truth[i].x()) < .7 &&
          std::abs(truth[i].y()) < .7) {
        sum += function(result[i], i);
        count += 1.;
      }
    return sum / count;
  }
};

/// Two square sheets, one above the other
/// \param side of the lower one; that of the upper one is 1
Scan two_sheets(double separation, double side, unsigned int seed = 1, double noise = sigma);

Normals turned(Normals normals);

Normals at_random(Normals normals);

/// How far the mean of each sheet is from where it should be, as a share of the separation
double approach(const Scan& scan, const Points& result, double separation);

/// The rms distance of the points from where they should be
double deviation(const Scan& scan, const Points& result);

} // namespace layers

#endif // POINT_SET_FLOW_TEST_LAYERS_TWO_SHEETS_H
