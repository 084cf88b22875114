// SPDX-License-Identifier: GPL-3.0-or-later
// Writes what is seen of the points of noisy clouds before the first step, and whether their neighbors are those
// of two sheets.
//   record_sheets OUT FIRST LAST     clouds FIRST to LAST - 1
// One record for each of some points of each cloud, of 32-bit floats: the number of the cloud; the share
// of neighbors on the opposite sheet; the cosine of the normal and the true one, positive if the point is on the
// side of its normal; the inputs of the gate; the number of neighbors; features of the point; features of the edges, 32 numbers each.
#include "training_clouds.h"

#include <CGAL/Point_set_flow/Learned_curvature.h>
#include <CGAL/Point_set_flow/smooth_block.h>
#include <CGAL/balanced_flow_smooth_point_set.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <map>

using namespace comparison;
namespace flow = CGAL::Point_set_flow;
typedef flow::internal::Sheet_input Input;
typedef flow::internal::Sheet_gate Gate;

struct Recorder_data {
  std::map<std::array<double, 3>, Surface_point> closest; ///< of each point, in the frame
  std::ofstream* out;
  unsigned int seed;
  unsigned int every;
  std::size_t visited = 0, records = 0, mixed = 0;
  const Surface_point& at(const Point_3& p) const { return closest.at({p.x(), p.y(), p.z()}); }
};

class Recorder : public flow::Tangent_plane_curvature {
  Recorder_data* m_data;

public:
  static constexpr unsigned int number_of_sheet_rounds =
      flow::Learned_curvature::number_of_sheet_rounds + 1;
  explicit Recorder(Recorder_data& data) : m_data(&data) {}
  flow::Sheet_evidence find_sheets(const flow::Neighborhood_3& neighborhood,
                                   unsigned int round) const
  {
    if (round + 1 < number_of_sheet_rounds)
      return flow::Learned_curvature().find_sheets(neighborhood, round);
    if (m_data->visited++ % m_data->every == 0 && neighborhood.deviation() > 0.)
      record(neighborhood);
    return neighborhood.sheets();
  }
  void record(const flow::Neighborhood_3& neighborhood) const
  {
    const Surface_point& own = m_data->at(neighborhood.center());
    std::size_t opposite = 0;
    double height = 0.; // above the other sheet
    for (std::size_t j = 0; j < neighborhood.size(); ++j) {
      const Surface_point& other = m_data->at(neighborhood[j]);
      if (other.normal * own.normal < -.5) {
        ++opposite;
        height += (own.point - other.point) * neighborhood.normal();
      }
    }
    const double cosine = std::copysign(own.normal * neighborhood.normal(), height);
    const Input x(neighborhood);
    std::vector<float> numbers = {float(m_data->seed), float(opposite) / float(neighborhood.size()),
                                  float(cosine)};
    for (const double number : Gate(neighborhood).input)
      numbers.push_back(float(number));
    numbers.push_back(float(x.size));
    append(numbers, x);
    m_data->out->write(reinterpret_cast<const char*>(numbers.data()),
                       std::streamsize(numbers.size() * sizeof(float)));
    ++m_data->records;
    m_data->mixed += opposite * 10 > neighborhood.size();
  }
};

int main(int argc, char** argv)
{
  return for_each_training_cloud(
      argc, argv, true, [](unsigned int seed, const Training_cloud& cloud, std::ofstream& out) {
        const flow::Coordinate_frame frame =
            flow::find_coordinate_frame<CGAL::Sequential_tag>(cloud.points);
        Recorder_data data;
        data.out = &out;
        data.seed = seed;
        data.every = unsigned(1 + cloud.points.size() / 4000);
        for (const Point_3& p : cloud.points) {
          const Point_3 q = CGAL::ORIGIN + (p - frame.center) / frame.unit;
          data.closest[{q.x(), q.y(), q.z()}] = cloud.surface->closest(p);
        }
        Points smoothed = cloud.points;
        CGAL::balanced_flow_smooth_point_set<CGAL::Sequential_tag>(
            smoothed, CGAL::parameters::curvature(Recorder(data)).number_of_iterations(1));
        std::printf("%u %s: %zu records, %zu of two sheets\n", seed, cloud.name.c_str(),
                    data.records, data.mixed);
      });
}
