// SPDX-License-Identifier: GPL-3.0-or-later
#include "Epick_points.h"

#include "measure/Numbered_points.h"
#include "measure/Smoothing_measures.h"

#include <CGAL/Random.h>
#include <CGAL/Shape_detection/Efficient_RANSAC.h>

#include <tuple>

namespace comparison {

Plane_measures measure_planes(const Points& scan, const Points& smoothed, const Vectors& normals,
                              double epsilon, unsigned int runs)
{
  // point, normal, point of the scan: the detection reorders its input
  typedef std::tuple<Epick::Point_3, Epick::Vector_3, Epick::Point_3> Smoothed_point;
  typedef std::vector<Smoothed_point> Input;
  typedef CGAL::Shape_detection::Efficient_RANSAC_traits<
      Epick, Input, CGAL::Nth_of_tuple_property_map<0, Smoothed_point>,
      CGAL::Nth_of_tuple_property_map<1, Smoothed_point>>
      Traits;
  typedef CGAL::Shape_detection::Efficient_RANSAC<Traits> Ransac;

  const Vectors lines =
      normals.empty()
          ? normals_in_order(with_normals<CGAL::Parallel_if_available_tag>(smoothed, false))
          : normals;
  const Epick_points points = to_epick(smoothed), of_scan = to_epick(scan);
  Input input;
  for (std::size_t i = 0; i < points.size(); ++i)
    input.emplace_back(points[i], Epick::Vector_3(lines[i].x(), lines[i].y(), lines[i].z()),
                       of_scan[i]);
  Plane_measures mean;
  for (unsigned int run = 0; run < runs; ++run) {
    CGAL::get_default_random() = CGAL::Random(run);
    Ransac ransac;
    ransac.set_input(input);
    ransac.add_shape_factory<CGAL::Shape_detection::Plane<Traits>>();
    Ransac::Parameters parameters;
    parameters.min_points = 200;
    parameters.epsilon = epsilon;
    parameters.normal_threshold = .9;
    parameters.probability = .01;
    ransac.detect(parameters);

    Error_sum residual, residual_of_scan;
    for (const auto& shape : ransac.shapes())
      for (const std::size_t i : shape->indices_of_assigned_points()) {
        residual.add(std::sqrt(shape->squared_distance(std::get<0>(input[i]))));
        residual_of_scan.add(std::sqrt(shape->squared_distance(std::get<2>(input[i]))));
        mean.share += 1. / double(input.size());
      }
    mean.planes += double(ransac.shapes().size());
    mean.residual += residual.rms();
    mean.of_scan += residual_of_scan.rms();
  }
  for (double* value : {&mean.planes, &mean.share, &mean.residual, &mean.of_scan})
    *value /= double(runs);
  return mean;
}

} // namespace comparison
