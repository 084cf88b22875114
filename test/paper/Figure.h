// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_PAPER_FIGURE_H
#define POINT_SET_FLOW_PAPER_FIGURE_H

#include "measure/Result_table.h"
#include "measure/Smoothing_measures.h"

#include <array>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>

namespace comparison {

typedef std::vector<double> Numbers;
typedef std::vector<std::array<std::size_t, 3>> Triangles;

/// A picture in the making: panels, which render.py draws, as files that VTK reads, and the list of them.
///
/// All points of a picture are drawn as discs of one size, which just cover the surface of the
/// first panel: where a smoother pulls points apart there are holes to be seen.
class Figure {
  std::filesystem::path m_folder;
  std::string m_name;
  std::ofstream m_list;
  std::size_t m_panels = 0;
  double m_disc_radius = 0.;

  std::ofstream open_panel(const std::string& caption)
  {
    const std::string file = m_name + "_" + std::to_string(m_panels++) + ".vtk";
    m_list << "panel\t" << file << '\t' << caption << std::endl;
    std::ofstream out = open(file);
    out << "# vtk DataFile Version 3.0\n" << m_name << "\nASCII\nDATASET POLYDATA\n";
    out << "FIELD field 1\ndisc_radius 1 1 float\n" << m_disc_radius << '\n';
    return out;
  }

  std::ofstream open(const std::string& file) const
  {
    std::ofstream out(m_folder / file);
    if (!out)
      throw std::runtime_error("cannot write " + (m_folder / file).string());
    out.precision(7);
    return out;
  }

  template <typename Range>
  static void write_all(std::ostream& out, const Range& range)
  {
    for (const auto& x : range)
      out << x << '\n';
  }

public:
  Figure(const std::filesystem::path& folder, const std::string& name)
      : m_folder(folder), m_name(name), m_list(open(name + ".panels"))
  {
    m_list.precision(7);
  }

  /// What the colors of all panels with values mean
  void set_range(double low, double high, const std::string& title)
  {
    m_list << "range\t" << low << '\t' << high << '\t' << title << std::endl;
  }

  /// Points as discs across their PCA normals, of few neighbors to let noise be seen; colored by values
  /// if there are any
  void add_points(const std::string& caption, const Points& points, const Numbers& values = {})
  {
    if (m_panels == 0)
      m_disc_radius = .75 * typical_distance(points, 6);
    std::ofstream out = open_panel(caption);
    out << "POINTS " << points.size() << " float\n";
    write_all(out, points);
    out << "POINT_DATA " << points.size() << "\nNORMALS normals float\n";
    write_all(out, normals_in_order(with_normals<CGAL::Sequential_tag>(points, false, 10)));
    if (!values.empty()) {
      out << "SCALARS value float 1\nLOOKUP_TABLE default\n";
      write_all(out, values);
    }
    close(out);
  }

  void add_mesh(const std::string& caption, const Points& points, const Triangles& triangles)
  {
    std::ofstream out = open_panel(caption);
    out << "POINTS " << points.size() << " float\n";
    write_all(out, points);
    out << "POLYGONS " << triangles.size() << ' ' << 4 * triangles.size() << '\n';
    for (const auto& t : triangles)
      out << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
    close(out);
  }

  /// Rows of numbers for gnuplot
  void write_curves(const std::string& name, const std::vector<Numbers>& rows) const
  {
    std::ofstream out = open(name + ".txt");
    for (const Numbers& row : rows) {
      for (const double x : row)
        out << x << ' ';
      out << '\n';
    }
    close(out);
  }

  /// Also prints it.
  void write_table(const Result_table& table, const std::string& suffix = "") const
  {
    std::ofstream out = open(m_name + suffix + ".md");
    table.write_markdown(out);
    close(out);
    std::cout << "\n" << m_name << suffix << "\n";
    table.write_markdown(std::cout);
    std::cout.flush();
  }

private:
  static void close(std::ostream& out)
  {
    if (!out.flush())
      throw std::runtime_error("writing failed");
  }

  /// The median distance to the i-th neighbor
  static double typical_distance(const Points& points, unsigned int i)
  {
    const Nearest_points nearest(points);
    Numbers distances;
    for (const Point_3& p : points)
      distances.push_back(std::sqrt(nearest(p, i + 1).back().second));
    const auto middle = distances.begin() + std::ptrdiff_t(distances.size() / 2);
    std::nth_element(distances.begin(), middle, distances.end());
    return *middle;
  }
};

} // namespace comparison

#endif // POINT_SET_FLOW_PAPER_FIGURE_H
