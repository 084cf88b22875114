// SPDX-License-Identifier: GPL-3.0-or-later
#include "smooth_by_pcl.h"

#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>
#include <pcl/surface/mls.h>

#include <memory>

namespace comparison {

void smooth_by_pcl(Points& points, double radius, unsigned int threads)
{
  typedef pcl::PointXYZ Point;
  typedef pcl::PointCloud<Point> Cloud;
  const auto cloud = std::make_shared<Cloud>();
  cloud->reserve(points.size());
  for (const Point_3& p : points)
    cloud->push_back(Point(float(p.x()), float(p.y()), float(p.z())));
  pcl::MovingLeastSquares<Point, Point> mls;
  mls.setInputCloud(cloud);
  mls.setSearchMethod(std::make_shared<pcl::search::KdTree<Point>>());
  mls.setPolynomialOrder(2);
  mls.setSearchRadius(radius);
  mls.setNumberOfThreads(threads);
  Cloud smoothed;
  mls.process(smoothed);
  // points with less than three neighbors are missing
  const pcl::Indices& kept = mls.getCorrespondingIndices()->indices;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const Point& p = smoothed[i];
    points[std::size_t(kept[i])] = Point_3(p.x, p.y, p.z);
  }
}

} // namespace comparison
