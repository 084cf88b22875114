// SPDX-License-Identifier: GPL-3.0-or-later
#include "write_errors.h"

#include <CGAL/Point_set_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>

namespace comparison {

bool write_errors(const std::string& file, const Points& points, const std::vector<double>& errors,
                  double range)
{
  CGAL::Point_set_3<Point_3> cloud;
  auto error_map = cloud.add_property_map<double>("signed_error", 0.).first;
  auto red = cloud.add_property_map<unsigned char>("red", 0).first;
  auto green = cloud.add_property_map<unsigned char>("green", 0).first;
  auto blue = cloud.add_property_map<unsigned char>("blue", 0).first;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto index = *cloud.insert(points[i]);
    const double share = (std::max)(-1., (std::min)(1., errors[i] / range));
    const auto faded = static_cast<unsigned char>(std::lround(255. * (1. - std::abs(share))));
    error_map[index] = errors[i];
    red[index] = share < 0. ? faded : 255;
    green[index] = faded;
    blue[index] = share > 0. ? faded : 255;
  }
  std::ofstream out(file, std::ios::binary);
  CGAL::IO::set_binary_mode(out);
  out << cloud;
  return bool(out.flush());
}

} // namespace comparison
