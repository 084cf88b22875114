// SPDX-License-Identifier: GPL-3.0-or-later
// Compares this package with the smoothers of CGAL and with the flows of the paper.
//   compare_smoothers mesh.off               samples the mesh, adds noise, and knows the truth
//   compare_smoothers noisy.xyz clean.xyz    the same points in the same order
//   compare_smoothers scan.xyz               no truth: roughness, spacing, movement and time only
// Prints a table and writes it as CSV and Markdown, with a cloud colored by its error for each
// method, into a folder; with --html also a page that shows the clouds side by side.
#include "Settings.h"
#include "measure/Result_table.h"
#include "measure/Smoothing_measures.h"
#include "measure/measure.h"
#include "measure/run_in_child.h"
#include "measure/write_errors.h"
#include "methods.h"
#include "page/Comparison_page.h"
#include "read_data.h"

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

using namespace comparison;

namespace {

bool is_chosen(const Settings& s, const std::string& method)
{
  return s.methods.empty() ||
         std::find(s.methods.begin(), s.methods.end(), method) != s.methods.end();
}

/// Whether the page draws a method: one that was asked for, or else one of the best known.
bool is_drawn(const Settings& s, const std::string& method)
{
  return s.html && (s.methods.empty() ? method == "none" || method == "jet" ||
                                            method == "bilateral" || method == "ours"
                                      : is_chosen(s, method));
}

/// What the page says of the data.
void describe(Comparison_page& page, const Settings& s, const Noisy_data& data,
              const Unit_sphere_map& map, double noise)
{
  const auto name = [](const std::string& file) {
    return std::filesystem::path(file).filename().string();
  };
  std::ostringstream input;
  if (s.files.size() == 2)
    input << data.noisy.size() << " points of " << name(s.files[0]) << "; the truth is "
          << name(s.files[1]);
  else if (data.surface)
    input << s.n << " samples of " << name(s.files[0]) << " with Gaussian noise of " << s.noise
          << "% of the radius, seed " << s.seed;
  else
    input << data.noisy.size() << " points of " << name(s.files[0]) << "; the truth is not known";
  page.set("input", input.str());
  page.set("radius", map.radius);
  if (data.surface)
    page.set("noise", noise);
}

/// Runs a method in a process of its own; says so if it failed.
std::optional<Run> run_method(const Named_method& method, const Points& noisy)
{
  std::cerr << method.title << " ..." << std::endl;
  std::optional<Run> run = run_in_child([&]() { return method.run(noisy); });
  if (run && all_finite(run->smoothed.points))
    return run;
  std::cerr << method.title << " failed" << std::endl;
  return std::nullopt;
}

/// Writes a cloud back in the unit of the data.
/// \param errors of the points, to the unit sphere; empty if they are not known
/// \param range of the errors that have colors of their own
void write_cloud(const std::string& file, const Points& points, std::vector<double> errors,
                 double range, const Unit_sphere_map& map)
{
  Points in_place;
  for (const Point_3& p : points)
    in_place.push_back(map.inverse(p));
  errors.resize(points.size(), 0.);
  for (double& error : errors)
    error *= map.radius;
  if (!write_errors(file, in_place, errors, range * map.radius))
    throw std::runtime_error("cannot write " + file);
}

std::string explain_columns(const Unit_sphere_map& map)
{
  // clang-format off
  return "Lengths in thousandths of the radius of the shape, " + std::to_string(map.radius) +
         " in the unit of the data; CD\n"
         "(two-way squared Chamfer distance to the clean points) and P2M (mean squared distance to the\n"
         "surface) x 10,000 of it. signed mean: negative is shrinkage. drift: rms movement within the\n"
         "surface. spacing CV: standard deviation by mean of the distance to the nearest point.\n"
         "roughness: rms distance to the plane of 18 neighbors. normal deg: mean angle to the true\n"
         "normals, of the smoother's own normals if it has any, else of PCA's (k=18) on the result. MB:\n"
         "peak memory above that at the start.\n";
  // clang-format on
}

/// Prints the table and writes it as CSV and Markdown.
void write_table(const Result_table& table, const std::string& explanation,
                 const std::filesystem::path& folder)
{
  std::cout << explanation << '\n';
  table.write_markdown(std::cout);
  std::ofstream csv(folder / "comparison.csv"), markdown(folder / "comparison.md");
  table.write_csv(csv);
  markdown << explanation << '\n';
  table.write_markdown(markdown);
  if (!csv.flush() || !markdown.flush())
    throw std::runtime_error("cannot write into " + folder.string());
}

int run(const Settings& s)
{
  const std::vector<Named_method> methods = all_methods();
  for (const std::string& name : s.methods)
    if (std::none_of(methods.begin(), methods.end(), [&](const auto& m) { return m.name == name; }))
      throw std::invalid_argument("there is no method \"" + name + "\"");
  const std::filesystem::path folder(s.output);
  std::filesystem::create_directories(folder);

  Unit_sphere_map map;
  const Noisy_data data = read_data(s, map);
  const double noise =
      data.surface ? Surface_errors(data.noisy, *data.surface, data.clean.near_edge).all.rms() : 0.;
  const double range = 2. * noise;
  Comparison_page page(s.html_points);
  describe(page, s, data, map, noise);
  Result_table table;
  bool all_ran = true;
  for (const Named_method& method : methods) {
    if (!is_chosen(s, method.name))
      continue;
    const std::optional<Run> run = run_method(method, data.noisy);
    if (!run) {
      all_ran = false;
      continue;
    }
    const Points& points = run->smoothed.points;
    std::vector<double> errors;
    table.add(method.title, measure(data, run->smoothed, run->seconds, run->megabytes, errors));
    if (is_drawn(s, method.name))
      page.add(method.name, method.title, points, errors, true);
    write_cloud((folder / (method.name + ".ply")).string(), points, errors, range, map);
  }

  write_table(table, explain_columns(map), folder);
  if (data.surface)
    std::cout << "\nColors of the clouds in " << s.output << ": blue " << -range * map.radius
              << " and less, red " << range * map.radius << " and more.\n";
  if (s.html && data.surface)
    page.add("truth", "truth", data.clean.points, std::vector<double>(data.clean.points.size(), 0.),
             false);
  if (s.html)
    page.write((folder / "comparison.html").string(), table);
  return all_ran ? EXIT_SUCCESS : EXIT_FAILURE;
}

} // namespace

int main(int argc, char** argv)
{
  try {
    const std::optional<Settings> settings = read_command_line(argc, argv);
    return settings ? run(*settings) : EXIT_SUCCESS;
  }
  catch (const std::exception& error) {
    std::cerr << "compare_smoothers: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }
}
