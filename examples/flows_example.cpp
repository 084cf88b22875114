// SPDX-License-Identifier: GPL-3.0-or-later
// Each flow of the paper, with the paper's estimator, a flow and an estimator of a user, on the same
// noisy sphere: what is left of the noise, and how much the sphere shrinks.
#include <CGAL/Point_set_flow/Covariance_curvature.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/balanced_flow_smooth_point_set.h>
#include <CGAL/point_generators_3.h>

#include <cmath>
#include <iomanip>
#include <iostream>
#include <vector>

typedef CGAL::Simple_cartesian<double>::Point_3 Point_3;
using namespace CGAL::Point_set_flow;

// A flow of your own: Eq. (9) with half of the forcing
struct Loosely_balanced_flow {
  Vector_3 operator()(const Flow_point_3& u, const Diffusivity& diffusivity) const
  {
    const double g = diffusivity(u.filtered_variation);
    return -(g * u.directional_curvature) * u.normal + .5 * (1. - g) * u.forcing;
  }
};

// An estimator of your own: the paper's, but points move as far as Eq. (3) says if that is less
struct Cautious_curvature {
  Tangent_plane_3 tangent_plane(const Neighborhood_3& neighborhood) const
  {
    return Covariance_curvature().tangent_plane(neighborhood);
  }

  double directional_curvature(const Neighborhood_3& neighborhood,
                               const Tangent_plane_3& plane) const
  {
    const double height = Covariance_curvature::direction(neighborhood, plane.normal);
    const double speed = Covariance_curvature().directional_curvature(neighborhood, plane);
    return std::abs(height) < std::abs(speed) ? height : speed;
  }
};

void print(const char* name, const std::vector<Point_3>& points)
{
  double mean = 0., square = 0.;
  for (const Point_3& p : points) {
    const double radius = std::sqrt((p - CGAL::ORIGIN).squared_length());
    mean += radius / double(points.size());
    square += (radius - 1.) * (radius - 1.) / double(points.size());
  }
  std::cout << std::left << std::setw(28) << name << " rms error " << std::setw(11)
            << std::sqrt(square) << " mean radius " << mean << std::endl;
}

template <typename Flow, typename Curvature = Covariance_curvature>
void smooth_and_print(const char* name, std::vector<Point_3> points, const Flow& flow,
                      const Curvature& curvature = Curvature())
{
  CGAL::balanced_flow_smooth_point_set<CGAL::Parallel_if_available_tag>(
      points, 20, CGAL::parameters::flow(flow).curvature(curvature).number_of_iterations(40));
  print(name, points);
}

int main()
{
  CGAL::Random random(1);
  std::vector<Point_3> points;
  std::copy_n(CGAL::Random_points_on_sphere_3<Point_3>(1., random), 5000,
              std::back_inserter(points));
  for (Point_3& p : points)
    p = CGAL::ORIGIN + (1. + random.get_double(-.02, .02)) * (p - CGAL::ORIGIN);

  print("noisy", points);
  smooth_and_print("curvature flow (4)", points, Curvature_flow());
  smooth_and_print("anisotropic flow (5)", points, Anisotropic_flow());
  smooth_and_print("well-posed flow (6)", points, Well_posed_anisotropic_flow());
  smooth_and_print("volume-preserving flow (7)", points, Volume_preserving_flow());
  smooth_and_print("balanced flow (9)", points, Balanced_flow());
  smooth_and_print("loosely balanced, my own", points, Loosely_balanced_flow());
  smooth_and_print("cautious, my own", points, Balanced_flow(), Cautious_curvature());
}
