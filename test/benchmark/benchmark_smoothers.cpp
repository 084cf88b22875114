// SPDX-License-Identifier: GPL-3.0-or-later
// Accuracy and time of jet, bilateral and balanced flow smoothing on noisy samples of meshes, where
// the truth is known. Prints a Markdown table.
//   benchmark_smoothers [number of points] [mesh.off ...]
#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/version.h>
#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_traits.h>
#endif
#include <CGAL/AABB_tree.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/balanced_flow_smooth_point_set.h>
#include <CGAL/bilateral_smooth_point_set.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/grid_simplify_point_set.h>
#include <CGAL/jet_smooth_point_set.h>
#include <CGAL/mst_orient_normals.h>
#include <CGAL/pca_estimate_normals.h>
#include <CGAL/point_generators_3.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <random>
#include <string>
#include <utility>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point_3;
typedef Kernel::Vector_3 Vector_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;
typedef CGAL::AABB_face_graph_triangle_primitive<Mesh> Primitive;
#if CGAL_VERSION_NR >= 1060000000
typedef CGAL::AABB_tree<CGAL::AABB_traits_3<Kernel, Primitive>> Tree;
#else
typedef CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> Tree;
#endif
typedef std::vector<Point_3> Points;
typedef CGAL::Parallel_if_available_tag Concurrency_tag;

namespace np = CGAL::parameters;

/// Moves a mesh to the origin and scales it into the unit sphere.
void normalize(Mesh& mesh)
{
  CGAL::Bbox_3 box;
  for (const auto v : mesh.vertices())
    box += mesh.point(v).bbox();
  const Point_3 center((box.xmin() + box.xmax()) / 2, (box.ymin() + box.ymax()) / 2,
                       (box.zmin() + box.zmax()) / 2);
  double radius = 0.;
  for (const auto v : mesh.vertices())
    radius = (std::max)(radius, std::sqrt(CGAL::squared_distance(mesh.point(v), center)));
  for (const auto v : mesh.vertices())
    mesh.point(v) = CGAL::ORIGIN + (mesh.point(v) - center) / radius;
}

/// About n points spread evenly over a mesh: many random ones, of which a grid keeps some.
Points sample(const Mesh& mesh, std::size_t n)
{
  CGAL::Random random(7);
  CGAL::Random_points_in_triangle_mesh_3<Mesh> generator(mesh, get(CGAL::vertex_point, mesh),
                                                         random);
  Points points;
  std::copy_n(generator, 8 * n, std::back_inserter(points));
  const double cell = std::sqrt(CGAL::Polygon_mesh_processing::area(mesh) / double(n)) * .75;
  points.erase(CGAL::grid_simplify_point_set(points, cell), points.end());
  std::shuffle(points.begin(), points.end(), std::mt19937(3));
  points.resize((std::min)(points.size(), n));
  return points;
}

void bilateral(Points& points, unsigned int k, int times)
{
  typedef std::pair<Point_3, Vector_3> Pair;
  const auto maps = np::point_map(CGAL::First_of_pair_property_map<Pair>())
                        .normal_map(CGAL::Second_of_pair_property_map<Pair>());
  std::vector<Pair> pairs;
  for (const Point_3& p : points)
    pairs.emplace_back(p, CGAL::NULL_VECTOR);
  CGAL::pca_estimate_normals<Concurrency_tag>(pairs, 18, maps);
  CGAL::mst_orient_normals(pairs, 18, maps);
  for (int i = 0; i < times; ++i)
    CGAL::bilateral_smooth_point_set<Concurrency_tag>(pairs, k, maps.sharpness_angle(25));
  // orienting sorts the points: the order is another one now, which no measure here looks at
  for (std::size_t i = 0; i < points.size(); ++i)
    points[i] = pairs[i].first;
}

int main(int argc, char** argv)
{
  const std::size_t n = argc > 1 ? std::stoul(argv[1]) : 10000;
  std::vector<std::string> meshes(argv + (std::min)(argc, 2), argv + argc);
  if (meshes.empty())
    for (const char* name : {"fandisk", "elephant", "octahedron", "cow", "armadillo"})
      meshes.push_back(CGAL::data_file_path(std::string("meshes/") + name + ".off"));

  std::printf("rms distance to the surface x 1000, shapes of radius 1, %zu points\n\n", n);
  std::printf("| shape | noise %% | noisy | jet k=24 | bilateral k=24, 3 times | balanced flow | "
              "to the better peer |\n"
              "|---|---|---|---|---|---|---|\n");
  double log_ratio = 0., seconds[3] = {0., 0., 0.};
  int cases = 0;
  for (const std::string& file : meshes) {
    Mesh mesh;
    if (!CGAL::IO::read_polygon_mesh(file, mesh) || mesh.is_empty()) {
      std::cerr << "cannot read " << file << std::endl;
      return EXIT_FAILURE;
    }
    CGAL::Polygon_mesh_processing::triangulate_faces(mesh);
    normalize(mesh);
    const Tree tree(faces(mesh).begin(), faces(mesh).end(), mesh);
    const Points clean = sample(mesh, n);
    for (const double sigma : {.005, .01, .02, .03}) {
      Points noisy = clean;
      std::mt19937 random(11);
      std::normal_distribution<double> noise(0., sigma);
      for (Point_3& p : noisy) {
        const double x = noise(random), y = noise(random), z = noise(random);
        p = p + Vector_3(x, y, z);
      }
      const auto error_after = [&](double& time, const auto& smooth) {
        Points points = noisy;
        CGAL::Real_timer timer;
        timer.start();
        smooth(points);
        timer.stop();
        time += timer.time();
        double sum = 0.;
        for (const Point_3& p : points)
          sum += tree.squared_distance(p);
        return 1000. * std::sqrt(sum / double(points.size()));
      };
      double unused = 0.;
      const double before = error_after(unused, [](Points&) {});
      const double jet = error_after(
          seconds[0], [](Points& p) { CGAL::jet_smooth_point_set<Concurrency_tag>(p, 24); });
      const double bilat = error_after(seconds[1], [](Points& p) { bilateral(p, 24, 3); });
      const double ours = error_after(
          seconds[2], [](Points& p) { CGAL::balanced_flow_smooth_point_set<Concurrency_tag>(p); });
      const double ratio = ours / (std::min)(jet, bilat);
      log_ratio += std::log(ratio);
      ++cases;
      const std::string name = file.substr(file.find_last_of('/') + 1);
      std::printf("| %s | %.1f | %.2f | %.2f | %.2f | %.2f | %.2f |\n",
                  name.substr(0, name.find('.')).c_str(), 100. * sigma, before, jet, bilat, ours,
                  ratio);
    }
  }
  std::printf("\ngeometric mean of the ratio: %.3f\n", std::exp(log_ratio / cases));
  std::printf("time to that of jet: bilateral with its normals %.2f, balanced flow %.2f\n",
              seconds[1] / seconds[0], seconds[2] / seconds[0]);
}
