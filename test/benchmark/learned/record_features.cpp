// SPDX-License-Identifier: GPL-3.0-or-later
// Writes what the learned correction sees of noisy clouds, and where it should move their points to.
//   record_features OUT FIRST LAST     clouds FIRST to LAST - 1
// One record for each of some points of each cloud, of 32-bit floats: the number of the cloud; the
// rms error of the cloud after the flow; the unit; the movement to the surface along the normal in units;
// the number of neighbors; features of the point; features of the edges, 32 numbers each.
#include "training_clouds.h"

#include <CGAL/Point_set_flow/Coordinate_frame.h>
#include <CGAL/Point_set_flow/Learned_curvature.h>
#include <CGAL/Point_set_flow/smooth_block.h>
#include <CGAL/balanced_flow_smooth_point_set.h>

#include <cstdio>
#include <fstream>
#include <iostream>

using namespace comparison;
namespace flow = CGAL::Point_set_flow;
typedef flow::internal::Correction_input Features;

struct Record {
  Point_3 point;
  Vector_3 normal;
  Features features;
};

/// An estimator that notes what is seen after the last correction there is
class Recorder : public flow::Learned_curvature {
  std::vector<Record>* m_records;

public:
  static constexpr unsigned int number_of_corrections =
      flow::Learned_curvature::number_of_corrections + 1;
  explicit Recorder(std::vector<Record>& records) : m_records(&records) {}
  double correction(const flow::Neighborhood_3& neighborhood, unsigned int round) const
  {
    if (round + 1 < number_of_corrections)
      return flow::Learned_curvature::correction(neighborhood, round);
    if (neighborhood.is_sided()) {
      const flow::internal::Same_side same(neighborhood);
      if (same.neighborhood().size() >= 2)
        record(same.neighborhood());
    }
    else
      record(neighborhood);
    return 0.;
  }
  void record(const flow::Neighborhood_3& neighborhood) const
  {
    m_records->push_back({neighborhood.center(), neighborhood.normal(), Features(neighborhood)});
  }
};

int main(int argc, char** argv)
{
  return for_each_training_cloud(
      argc, argv, false, [](unsigned int seed, const Training_cloud& cloud, std::ofstream& out) {
        const flow::Coordinate_frame frame =
            flow::find_coordinate_frame<CGAL::Sequential_tag>(cloud.points);
        Points smoothed = cloud.points;
        std::vector<Record> records;
        CGAL::balanced_flow_smooth_point_set<CGAL::Sequential_tag>(
            smoothed, CGAL::parameters::curvature(Recorder(records)));
        std::mt19937 random(seed);
        std::shuffle(records.begin(), records.end(), random);
        const std::size_t most = 4000;
        if (records.size() > most)
          records.resize(most, records.front());
        double squares = 0.;
        std::vector<double> distances;
        std::vector<Vector_3> ways;
        for (const Record& r : records) {
          const Point_3 p = frame.center + frame.unit * (r.point - CGAL::ORIGIN);
          const Surface_point closest = cloud.surface->closest(p);
          ways.push_back(closest.point - p);
          distances.push_back(ways.back().squared_length());
        }
        std::vector<double> sorted = distances; // without outliers
        std::sort(sorted.begin(), sorted.end());
        for (std::size_t i = 0; i < sorted.size() * 98 / 100; ++i)
          squares += sorted[i];
        const double rms = std::sqrt(squares / (double(sorted.size()) * .98 + 1e-300));
        for (std::size_t i = 0; i < records.size(); ++i) {
          const Features& f = records[i].features;
          std::vector<float> numbers = {float(seed), float(rms), float(f.unit * frame.unit),
                                        float(ways[i] * records[i].normal / (f.unit * frame.unit)),
                                        float(f.size)};
          append(numbers, f);
          out.write(reinterpret_cast<const char*>(numbers.data()),
                    std::streamsize(numbers.size() * sizeof(float)));
        }
        std::printf("%u %s: %zu records, rms %g\n", seed, cloud.name.c_str(), records.size(), rms);
      });
}
