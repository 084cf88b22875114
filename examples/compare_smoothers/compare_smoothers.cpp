// SPDX-License-Identifier: GPL-3.0-or-later
// Compares this package with the smoothers of CGAL and with the flows of the paper.
//   compare_smoothers mesh.off               samples the mesh, adds noise, and knows the truth
//   compare_smoothers noisy.xyz clean.xyz    the same points in the same order
//   compare_smoothers scan.xyz               no truth: roughness, spacing, movement and time only
// Prints a table and writes it as CSV and Markdown, with a cloud colored by its error for each
// method, into a folder; with --html also a page that shows the clouds side by side.
#include "comparison/Comparison_page.h"
#include "comparison/Noise_models.h"
#include "comparison/Point_surface.h"
#include "comparison/measure.h"
#include "comparison/read_mesh.h"
#include "comparison/run_in_child.h"
#include "comparison/sample_mesh.h"
#include "comparison/write_errors.h"

#include <CGAL/IO/read_points.h>

#include <boost/program_options.hpp>

#include <filesystem>

namespace options = boost::program_options;

namespace {

struct Settings {
  std::vector<std::string> files, methods;
  std::string output;
  std::size_t n;
  unsigned int seed;
  double noise;
  bool cloud, html;
  std::size_t html_points;
};

typedef std::function<Smoothed(const Points&)> Method;

/// Short name (option --methods, file names), title, and call of all methods
struct Named_method {
  std::string name, title;
  Method run;
};

std::vector<Named_method> all_methods()
{
  using namespace CGAL::Point_set_flow;
  // clang-format off
  return {
    {"none", "none", [](const Points& p) { return Smoothed{p, {}}; }},
    {"jet", "jet, k=24", [](const Points& p) { return jet(p, 24); }},
    {"bilateral", "bilateral, k=24, 3 times", [](const Points& p) { return bilateral(p, 24, 3); }},
    {"wlop", "WLOP", [](const Points& p) { return wlop(p); }},
    {"curvature", "curvature flow (4)", [](const Points& p) { return paper_flow(p, Curvature_flow()); }},
    {"anisotropic", "anisotropic flow (5)", [](const Points& p) { return paper_flow(p, Anisotropic_flow()); }},
    {"well-posed", "well-posed flow (6)", [](const Points& p) { return paper_flow(p, Well_posed_anisotropic_flow()); }},
    {"volume-preserving", "volume-preserving flow (7)", [](const Points& p) { return paper_flow(p, Volume_preserving_flow()); }},
    {"balanced", "balanced flow (9)", [](const Points& p) { return paper_flow(p, Balanced_flow()); }},
    {"ours", "this package, defaults", [](const Points& p) { return point_set_flow(p); }}};
  // clang-format on
}

std::optional<Settings> read_command_line(int argc, char** argv)
{
  Settings s;
  options::options_description description(
      "Usage: compare_smoothers mesh | noisy clean | scan [options]\n\n"
      "Compares smoothers: on samples of a mesh with noise added, on a noisy and a clean file "
      "with\n"
      "the same points in the same order, or on one file without a truth.\n\nOptions");
  // clang-format off
  description.add_options()
    ("help,h", "print this text")
    ("points,n", options::value(&s.n)->default_value(10000), "number of samples of a mesh")
    ("noise", options::value(&s.noise)->default_value(1.), "standard deviation of the noise, in percent of the mesh's radius")
    ("seed", options::value(&s.seed)->default_value(1), "of the samples and the noise")
    ("cloud", options::bool_switch(&s.cloud), "take the vertices of a mesh file as a scan")
    ("methods", options::value(&s.methods)->multitoken(),
     "some of: none jet bilateral wlop curvature anisotropic well-posed volume-preserving balanced ours")
    ("html", options::bool_switch(&s.html), "write a page, too, that shows the clouds side by side: of --methods, or noisy, jet, bilateral and ours")
    ("html-points", options::value(&s.html_points)->default_value(200000), "the number of points that the page draws of a cloud; of more it draws a random sample")
    ("output,o", options::value(&s.output)->default_value("comparison"), "folder of the results");
  options::options_description files;
  files.add_options()("file", options::value(&s.files)->required(), "");
  // clang-format on
  options::positional_options_description positions;
  positions.add("file", -1);
  options::variables_map given;
  options::options_description all;
  all.add(description).add(files);
  options::store(options::command_line_parser(argc, argv).options(all).positional(positions).run(),
                 given);
  if (given.count("help")) {
    std::cout << description;
    return std::nullopt;
  }
  options::notify(given);
  if (s.files.size() > 2)
    throw std::invalid_argument("one or two files");
  if (s.n < 20 || !(s.noise >= 0.))
    throw std::invalid_argument("--points must be at least 20 and --noise not negative");
  if (s.html_points < 1)
    throw std::invalid_argument("--html-points must be at least 1");
  return s;
}

Points read_cloud(const std::string& file)
{
  Points points;
  if (!CGAL::IO::read_points(file, std::back_inserter(points)) || points.size() < 20)
    throw std::runtime_error("cannot read 20 points or more from " + file);
  return points;
}

/// What the smoothers get, and what is known of the truth; says what that is.
Noisy_data read_data(const Settings& s, Unit_sphere_map& map)
{
  Noisy_data data;
  if (s.files.size() == 2) {
    data.noisy = read_cloud(s.files[0]);
    data.clean.points = read_cloud(s.files[1]);
    if (data.noisy.size() != data.clean.points.size())
      throw std::runtime_error("the two files have different numbers of points");
    map = Unit_sphere_map::of(data.clean.points);
    map.apply(data.noisy);
    map.apply(data.clean.points);
    auto surface = std::make_unique<Point_surface>(data.clean.points);
    data.clean.normals = surface->normals();
    data.clean.near_edge.assign(data.noisy.size(), false);
    data.surface = std::move(surface);
    std::cout << "Truth: the plane of the nearest clean point, with its PCA normal (k=18). Sharp "
                 "edges are not known.\n";
    return data;
  }

  std::optional<Mesh> mesh;
  if (!s.cloud && !(mesh = read_mesh(s.files[0], map))) // of points only, or not of a mesh's format
    std::cout << "No mesh in " << s.files[0] << ": taken as a scan.\n";
  if (!mesh) {
    data.noisy = read_cloud(s.files[0]);
    map = Unit_sphere_map::of(data.noisy);
    map.apply(data.noisy);
    std::cout << "Truth: not known.\n";
    return data;
  }

  auto surface = std::make_unique<Mesh_surface>(std::move(*mesh));
  const double sigma = s.noise / 100.;
  data.clean = sample_mesh(*surface, s.n, s.seed);
  data.edge_distance = 2. * std::sqrt(surface->area() / double(s.n)) + 3. * sigma;
  find_samples_near_edges(data.clean, *surface, data.edge_distance);
  data.noisy = add_noise(data.clean.points, "Gaussian", sigma, s.seed + 1).points;
  data.surface = std::move(surface);
  std::cout << "Truth: the mesh. Near its sharp edges (over 30 degrees, closer than "
            << 1e3 * data.edge_distance
            << "): " << std::count(data.clean.near_edge.begin(), data.clean.near_edge.end(), true)
            << " of " << s.n << " points.\n";
  return data;
}

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
    std::cerr << method.title << " ..." << std::endl;
    const std::optional<Run> run = run_in_child([&]() { return method.run(data.noisy); });
    if (!run || !all_finite(run->smoothed.points)) {
      std::cerr << method.title << " failed" << std::endl;
      all_ran = false;
      continue;
    }
    std::vector<double> errors;
    table.add(method.title, measure(data, run->smoothed, run->seconds, run->megabytes, errors));
    if (is_drawn(s, method.name))
      page.add(method.name, method.title, run->smoothed.points, errors, true);
    if (!data.surface)
      errors.assign(run->smoothed.points.size(), 0.);
    Points points;
    for (const Point_3& p : run->smoothed.points)
      points.push_back(map.inverse(p));
    const std::string file = (folder / (method.name + ".ply")).string();
    for (double& error : errors)
      error *= map.radius;
    if (!write_errors(file, points, errors, range * map.radius))
      throw std::runtime_error("cannot write " + file);
  }

  if (s.html && data.surface)
    page.add("truth", "truth", data.clean.points, std::vector<double>(data.clean.points.size(), 0.),
             false);
  const std::string explanation =
      "Lengths in thousandths of the radius of the shape, " + std::to_string(map.radius) +
      " in the unit of the data; CD\n"
      "(two-way squared Chamfer distance to the clean points) and P2M (mean squared distance to "
      "the\n"
      "surface) x 10,000 of it. signed mean: negative is shrinkage. drift: rms movement within "
      "the\n"
      "surface. spacing CV: standard deviation by mean of the distance to the nearest point.\n"
      "roughness: rms distance to the plane of 18 neighbors. normal deg: mean angle to the true\n"
      "normals, of the smoother's own normals if it has any, else of PCA's (k=18) on the result. "
      "MB:\n"
      "peak memory above that at the start.\n";
  std::cout << explanation << '\n';
  table.write_markdown(std::cout);
  std::ofstream csv(folder / "comparison.csv"), markdown(folder / "comparison.md");
  table.write_csv(csv);
  markdown << explanation << '\n';
  table.write_markdown(markdown);
  if (data.surface)
    std::cout << "\nColors of the clouds in " << s.output << ": blue " << -range * map.radius
              << " and less, red " << range * map.radius << " and more.\n";
  if (!csv.flush() || !markdown.flush())
    throw std::runtime_error("cannot write into " + s.output);
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
