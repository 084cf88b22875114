// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_BENCHMARK_BUILDING_RELIEF_H
#define POINT_SET_FLOW_BENCHMARK_BUILDING_RELIEF_H

#include "Wall_frame.h"

namespace comparison {

/// What is left of the relief of a building's wall, and of its roughness.
///
/// The wall is cut into cells. In a cell, the input's points of the same height, that is, without a
/// gap of more than `gap` between them, are a patch. Patches of neighboring cells of one row whose
/// heights differ by a relief are a step: of a pilaster against the wall, or of a frame.
/// - relief kept: the sum of the heights of the points of upper patches over the lower ones, after
///   smoothing, to that before. Points are compared with themselves, wherever they have gone.
/// - roughness: rms deviation of the points of flat patches from the planes that fit these; flat is
///   where the cells to all sides are of the same height, too
class Building_relief {
  typedef std::pair<long, long> Cell; // row, column
  static constexpr double cell_width = .25, cell_height = 1., gap = .035;
  static constexpr double least_step = .15, largest_step = .6;
  static constexpr std::size_t least_points = 6;

  struct Patch {
    std::vector<std::size_t> points;
    double height; // mean, of the input
    bool is_flat = false;
  };
  struct Step {
    std::size_t upper, lower;
  };
  std::vector<Patch> m_patches;
  std::vector<Step> m_steps;
  Wall_frame m_frame;
  Points m_input;

  static double mean_height(const Points& points, const std::vector<std::size_t>& chosen)
  {
    double sum = 0.;
    for (const std::size_t i : chosen)
      sum += points[i].z();
    return sum / double(chosen.size());
  }

  /// Adds the patches of a cell; returns their numbers.
  std::vector<std::size_t> add_patches(std::vector<std::size_t> cell)
  {
    std::sort(cell.begin(), cell.end(),
              [&](std::size_t i, std::size_t j) { return m_input[i].z() < m_input[j].z(); });
    std::vector<std::size_t> added;
    for (std::size_t begin = 0, end = 0; begin < cell.size(); begin = end) {
      for (end = begin + 1;
           end < cell.size() && m_input[cell[end]].z() - m_input[cell[end - 1]].z() < gap;)
        ++end;
      if (end - begin < least_points ||
          m_input[cell[end - 1]].z() - m_input[cell[begin]].z() > 2. * gap)
        continue; // few points, or a slope
      Patch patch{{cell.begin() + std::ptrdiff_t(begin), cell.begin() + std::ptrdiff_t(end)}, 0.};
      patch.height = mean_height(m_input, patch.points);
      added.push_back(m_patches.size());
      m_patches.push_back(std::move(patch));
    }
    return added;
  }

  void add_steps(const std::vector<std::size_t>& here, const std::vector<std::size_t>& there)
  {
    for (const std::size_t a : here)
      for (const std::size_t b : there) {
        const double step = m_patches[a].height - m_patches[b].height;
        if (std::abs(step) > least_step && std::abs(step) < largest_step)
          m_steps.push_back(step > 0. ? Step{a, b} : Step{b, a});
      }
  }

  /// Whether most points of a cell and of those around it have a height
  bool is_flat(const std::map<Cell, std::vector<std::size_t>>& cells, const Cell& cell,
               double height) const
  {
    std::size_t all = 0, same = 0;
    for (const long row : {-1, 0, 1})
      for (const long column : {-2, -1, 0, 1, 2}) {
        const auto found = cells.find({cell.first + row, cell.second + column});
        if (found == cells.end())
          return false;
        for (const std::size_t i : found->second)
          same += std::abs(m_input[i].z() - height) < gap;
        all += found->second.size();
      }
    return double(same) > .75 * double(all);
  }

  /// The rms deviation from the plane that fits a patch
  void add_deviations(const Points& points, const Patch& patch, Error_sum& sum) const
  {
    Vector_3 middle = CGAL::NULL_VECTOR;
    for (const std::size_t i : patch.points)
      middle += (points[i] - CGAL::ORIGIN) / double(patch.points.size());
    double xx = 0., xy = 0., yy = 0., xz = 0., yz = 0.;
    for (const std::size_t i : patch.points) {
      const Vector_3 d = points[i] - CGAL::ORIGIN - middle;
      xx += d.x() * d.x();
      xy += d.x() * d.y();
      yy += d.y() * d.y();
      xz += d.x() * d.z();
      yz += d.y() * d.z();
    }
    const double determinant = xx * yy - xy * xy;
    if (!(determinant > 1e-6 * xx * yy))
      return; // on a line
    const double a = (xz * yy - yz * xy) / determinant, b = (yz * xx - xz * xy) / determinant;
    for (const std::size_t i : patch.points) {
      const Vector_3 d = points[i] - CGAL::ORIGIN - middle;
      sum.add(d.z() - a * d.x() - b * d.y());
    }
  }

public:
  explicit Building_relief(const Points& input) : m_frame(input, 2.), m_input(m_frame(input))
  {
    std::map<Cell, std::vector<std::size_t>> cells;
    for (std::size_t i = 0; i < m_input.size(); ++i)
      if (std::abs(m_input[i].z()) < 1.5)
        cells[{std::lround(m_input[i].y() / cell_height), std::lround(m_input[i].x() / cell_width)}]
            .push_back(i);
    std::map<Cell, std::vector<std::size_t>> patches;
    for (const auto& [cell, points] : cells)
      patches[cell] = add_patches(points);
    for (const auto& [cell, here] : patches) {
      for (const long aside : {1, 2, 3})
        if (const auto found = patches.find({cell.first, cell.second + aside});
            found != patches.end())
          add_steps(here, found->second);
      for (const std::size_t patch : here)
        m_patches[patch].is_flat = is_flat(cells, cell, m_patches[patch].height);
    }
  }

  std::size_t number_of_steps() const { return m_steps.size(); }
  std::size_t number_of_flat_patches() const
  {
    return std::size_t(std::count_if(m_patches.begin(), m_patches.end(),
                                     [](const Patch& patch) { return patch.is_flat; }));
  }

  /// In the mean of the steps, and in the tenth of them that have lost most: what its best one keeps
  struct Kept {
    double mean, worst_tenth;
  };
  Kept relief_kept(const Points& smoothed) const
  {
    const Points points = m_frame(smoothed);
    double before = 0., after = 0.;
    std::vector<double> shares;
    for (const Step& step : m_steps) {
      const Patch &upper = m_patches[step.upper], &lower = m_patches[step.lower];
      const double n = double(upper.points.size()), was = upper.height - lower.height;
      const double is = mean_height(points, upper.points) - mean_height(points, lower.points);
      before += n * was;
      after += n * is;
      shares.push_back(is / was);
    }
    std::sort(shares.begin(), shares.end());
    return {after / before, shares[shares.size() / 10]};
  }

  double roughness(const Points& smoothed) const
  {
    const Points points = m_frame(smoothed);
    Error_sum sum;
    for (const Patch& patch : m_patches)
      if (patch.is_flat)
        add_deviations(points, patch, sum);
    return sum.rms();
  }
};

} // namespace comparison

#endif // POINT_SET_FLOW_BENCHMARK_BUILDING_RELIEF_H
