// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_BENCHMARK_VIRTUAL_SCANNER_H
#define POINT_SET_FLOW_BENCHMARK_VIRTUAL_SCANNER_H

#include "Ray_caster.h"

#include "field/Test_cloud.h"

namespace comparison {

/// How a scan is made. Lengths are in spacings of its points.
struct Scan_settings {
  std::string name;
  double noise = 0.;        ///< standard deviation along the rays
  double rounding = 0.;     ///< step of the ranges; 0 for none
  double registration = 0.; ///< rms error of the points by that of the positions
  double line_ratio = 1.;   ///< distance of scan lines to that of the points on a line
  bool edge_beams = false;  ///< whether beams have a width, so that some meet two surfaces
  bool two_surveys = false; ///< two registered to each other, of every other position each
  bool gives_normals = false;
  bool gives_scans = false; ///< the number of the survey of each point
};

/// What is scanned, and from where: shapes have a radius of 1 around the origin.
struct Scan_scene {
  std::string name;
  std::shared_ptr<const Mesh_surface> surface;
  Points positions;
};

/// Scanner positions all around a shape, at a distance of 3, more or less evenly
inline Points positions_around(unsigned int n, std::mt19937& random)
{
  std::uniform_real_distribution<double> unit(0., 1.);
  const double turn = unit(random);
  Points positions;
  for (unsigned int i = 0; i < n; ++i) { // on a spiral
    const double z = 1. - (2. * i + 1.) / n, r = std::sqrt(1. - z * z);
    const double angle = 2. * CGAL_PI * (turn + .618034 * i);
    positions.emplace_back(3. * r * std::cos(angle), 3. * r * std::sin(angle), 3. * z);
  }
  return positions;
}

/// Scans a scene from all positions with an angular grid, then makes the errors.
class Virtual_scanner {
  struct Beam {
    unsigned int position;
    Vector_3 direction; // of length 1
    double range;
    std::optional<double> other_range; // of the side of the beam that meets another surface
  };
  const Scan_scene& m_scene;
  const Scan_settings& m_settings;
  Ray_caster m_caster;
  std::mt19937 m_random;
  std::vector<Beam> m_beams;
  double m_step = 0.; // between the rays of a square grid, as a tangent

  double uniform(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(m_random);
  }
  double normal(double sigma) { return std::normal_distribution<double>(0., sigma)(m_random); }
  Vector_3 isotropic(double sigma)
  {
    const double x = normal(sigma), y = normal(sigma);
    return {x, y, normal(sigma)};
  }

  /// Casts the rays of a position that a shape of radius 1 can stop. The grid is square but for the
  /// lines, which keep the number of rays.
  void scan(unsigned int position, double step)
  {
    const Point_3& from = m_scene.positions[position];
    const Vector_3 to_center = CGAL::ORIGIN - from;
    const double distance = std::sqrt(to_center.squared_length());
    const Vector_3 ahead = to_center / distance;
    Vector_3 right = CGAL::cross_product(ahead, Vector_3(.3, .2, 1.));
    right = right / std::sqrt(right.squared_length());
    const Vector_3 up = CGAL::cross_product(right, ahead);
    const double extent = 1.05 / std::sqrt(distance * distance - 1.);
    const double across = step * std::sqrt(m_settings.line_ratio), along = step * step / across;
    const double shift = uniform(0., 1.);
    for (double u = -extent + shift * across; u < extent; u += across)
      for (double v = -extent + shift * along; v < extent; v += along) {
        const auto direction = [&](double a, double b) {
          const Vector_3 d = ahead + a * right + b * up;
          return d / std::sqrt(d.squared_length());
        };
        Beam beam{position, direction(u, v), 0., {}};
        const std::optional<double> range = m_caster.range(from, beam.direction);
        if (!range)
          continue;
        beam.range = *range;
        if (m_settings.edge_beams)
          beam.other_range = m_caster.range(from, direction(u + .4 * step, v + .3 * step));
        m_beams.push_back(beam);
      }
  }

  void scan_all(double step)
  {
    m_beams.clear();
    for (unsigned int i = 0; i < m_scene.positions.size(); ++i)
      scan(i, step);
    m_step = step;
  }

  Points true_points() const
  {
    Points points;
    for (const Beam& beam : m_beams)
      points.push_back(m_scene.positions[beam.position] + beam.range * beam.direction);
    return points;
  }

  struct Motion {
    Vector_3 turn, shift;
  };
  /// Motions of the positions, which move points at a radius of .7 by so much (rms); turns and shifts
  /// have equal parts in the square of it. In the mean they are none, as a registration leaves them.
  std::vector<Motion> registration_errors(double rms)
  {
    const std::size_t n = m_scene.positions.size();
    std::vector<Motion> motions;
    for (std::size_t i = 0; i < n; ++i) {
      const Vector_3 turn = isotropic(rms / std::sqrt(2. * 2. * .49));
      motions.push_back({turn, isotropic(rms / std::sqrt(2. * 3.))});
    }
    if (m_settings.two_surveys) {
      for (std::size_t i = 1; i < n; ++i) {
        const double side = i % 2 == 0 ? 1. : -1.;
        motions[i] = {side * motions[0].turn, side * motions[0].shift};
      }
      return motions;
    }
    Motion mean{CGAL::NULL_VECTOR, CGAL::NULL_VECTOR};
    for (const Motion& motion : motions) {
      mean.turn += motion.turn / double(n);
      mean.shift += motion.shift / double(n);
    }
    const double scale = std::sqrt(double(n) / double(n - 1)); // the mean took its part
    for (Motion& motion : motions)
      motion = {scale * (motion.turn - mean.turn), scale * (motion.shift - mean.shift)};
    return motions;
  }

  /// Where the beam's width meets two surfaces, the range is somewhere between.
  bool mix_ranges(Beam& beam)
  {
    if (!beam.other_range || std::abs(*beam.other_range - beam.range) < 10. * m_step * beam.range)
      return false;
    const double share = uniform(0., 1.);
    beam.range += share * (*beam.other_range - beam.range);
    return true;
  }

public:
  Virtual_scanner(const Scan_scene& scene, const Scan_settings& settings, unsigned int seed)
      : m_scene(scene), m_settings(settings), m_caster(scene.surface->mesh()), m_random(seed)
  {}

  /// About n points. Those of beams that met two surfaces do not belong to the shape.
  Test_cloud operator()(std::size_t n)
  {
    const double pilot = .03;
    scan_all(pilot);
    scan_all(pilot * std::sqrt(double(m_beams.size()) / double(n)));
    Test_cloud cloud;
    cloud.name = m_scene.name + ", " + m_settings.name;
    cloud.surface = m_scene.surface;
    const double h = cloud.spacing = typical_spacing(true_points());
    const std::vector<Motion> motions = registration_errors(m_settings.registration * h);
    for (Beam& beam : m_beams) {
      cloud.belongs.push_back(!mix_ranges(beam));
      double range = beam.range + normal(m_settings.noise * h);
      if (const double unit = m_settings.rounding * h; unit > 0.)
        range = unit * std::round(range / unit);
      const Point_3 p = m_scene.positions[beam.position] + range * beam.direction;
      const Motion& motion = motions[beam.position];
      cloud.points.push_back(p + motion.shift + CGAL::cross_product(motion.turn, p - CGAL::ORIGIN));
    }
    if (m_settings.gives_normals)
      give_normals(cloud);
    if (m_settings.gives_scans)
      for (const Beam& beam : m_beams)
        cloud.scans.push_back(m_settings.two_surveys ? beam.position % 2 : beam.position);
    return cloud;
  }

private:
  /// Those of planes through 18 points of the cloud, towards the scanner
  void give_normals(Test_cloud& cloud) const
  {
    cloud.normals = normals_in_order(with_normals<Concurrency_tag>(cloud.points, false));
    for (std::size_t i = 0; i < m_beams.size(); ++i)
      if (cloud.normals[i] * m_beams[i].direction > 0.)
        cloud.normals[i] = -cloud.normals[i];
  }
};

} // namespace comparison

#endif // POINT_SET_FLOW_BENCHMARK_VIRTUAL_SCANNER_H
