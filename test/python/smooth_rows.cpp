// SPDX-License-Identifier: GPL-3.0-or-later
// What the tests and the benchmark of the Python module compare with: the C++ function, called as in the manual.
//   smooth_rows float|double plain|numbers|arrays INPUT OUTPUT
// Rows of the input have nine numbers: point, normal, noise, scan, constrained; of the output six: point, normal.
// Prints the processor time of the call in seconds.
#include <CGAL/Simple_cartesian.h>
#include <CGAL/balanced_flow_smooth_point_set.h>

#include <array>
#include <cstddef>
#include <ctime>
#include <fstream>
#include <iostream>
#include <string>
#include <tuple>
#include <vector>

namespace {

template <typename FT>
void write_row(std::ostream& out, const std::array<FT, 6>& row)
{
  out.write(reinterpret_cast<const char*>(row.data()), sizeof row);
}

template <typename FT>
int smooth_rows(const std::string& mode, const char* input, const char* output)
{
  typedef CGAL::Simple_cartesian<FT> Kernel;
  typedef std::tuple<typename Kernel::Point_3, typename Kernel::Vector_3, double, int, bool> Point;
  std::vector<typename Kernel::Point_3> bare;
  std::vector<Point> points;
  std::ifstream in(input, std::ios::binary);
  for (std::array<FT, 9> r; in.read(reinterpret_cast<char*>(r.data()), sizeof r);)
    if (mode == "plain")
      bare.emplace_back(r[0], r[1], r[2]);
    else
      points.emplace_back(typename Kernel::Point_3(r[0], r[1], r[2]),
                          typename Kernel::Vector_3(r[3], r[4], r[5]), double(r[6]), int(r[7]),
                          r[8] != FT(0));

  namespace np = CGAL::parameters;
  typedef CGAL::Parallel_if_available_tag Tag;
  const CGAL::Nth_of_tuple_property_map<0, Point> point_map;
  const CGAL::Nth_of_tuple_property_map<1, Point> normal_map;
  const std::clock_t start = std::clock();
  if (mode == "plain")
    CGAL::balanced_flow_smooth_point_set<Tag>(bare);
  else if (mode == "numbers")
    CGAL::balanced_flow_smooth_point_set<Tag>(points, 30,
                                              np::noise(.02)
                                                  .step_length(.5)
                                                  .update_period(2)
                                                  .number_of_iterations(7)
                                                  .number_of_relaxation_steps(2)
                                                  .sharpness_angle(40.)
                                                  .neighbor_radius(.3)
                                                  .point_map(point_map));
  else
    CGAL::balanced_flow_smooth_point_set<Tag>(
        points, np::noise(CGAL::Nth_of_tuple_property_map<2, Point>())
                    .scan_map(CGAL::Nth_of_tuple_property_map<3, Point>())
                    .point_is_constrained_map(CGAL::Nth_of_tuple_property_map<4, Point>())
                    .point_map(point_map)
                    .normal_map(normal_map));
  std::cout << double(std::clock() - start) / CLOCKS_PER_SEC << std::endl;

  std::ofstream out(output, std::ios::binary);
  for (const auto& p : bare)
    write_row<FT>(out, {p.x(), p.y(), p.z()});
  for (const Point& point : points) {
    const auto& p = get(point_map, point);
    const auto& n = get(normal_map, point);
    write_row<FT>(out, {p.x(), p.y(), p.z(), n.x(), n.y(), n.z()});
  }
  return out.flush() ? 0 : 1;
}

} // namespace

int main(int argc, char** argv)
{
  if (argc != 5)
    return 1;
  return std::string(argv[1]) == "float" ? smooth_rows<float>(argv[2], argv[3], argv[4])
                                         : smooth_rows<double>(argv[2], argv[3], argv[4]);
}
