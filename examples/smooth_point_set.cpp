// SPDX-License-Identifier: GPL-3.0-or-later
// Smooths the points of a file and keeps everything else in it.
#include "Point_set_io.h"

#include <CGAL/Balanced_flow/Covariance_curvature.h>
#include <CGAL/Balanced_flow/estimate_point_set_scale.h>
#include <CGAL/Real_timer.h>
#include <CGAL/balanced_flow_smooth_point_set.h>

#include <boost/program_options.hpp>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <functional>
#include <optional>

namespace options = boost::program_options;
namespace flows = CGAL::Point_set_flow;

namespace {

enum Exit_code { SUCCESS = 0, BAD_USAGE = 1, BAD_FILE = 2, INTERRUPTED = 130 };

std::atomic<bool> interrupted(false);
extern "C" void on_interrupt(int)
{
  interrupted = true;
  std::signal(SIGINT, SIG_DFL); // the second one ends the program, whatever it does
}

/// Draws a progress bar, at most ten times a second, and stops the run after Ctrl-C.
class Progress_bar {
  bool m_visible;
  CGAL::Real_timer m_timer;
  double m_drawn = -1.;

public:
  explicit Progress_bar(bool visible) : m_visible(visible) { m_timer.start(); }

  bool operator()(double share)
  {
    if (m_visible && (share == 1. || m_timer.time() - m_drawn > .1)) {
      m_drawn = m_timer.time();
      const std::size_t width = 40, done = std::size_t(share * double(width));
      std::cerr << "\r[" << std::string(done, '=') << std::string(width - done, ' ') << "] "
                << int(100. * share) << "%" << (share == 1. ? "\n" : "") << std::flush;
    }
    return !interrupted;
  }
};

struct Settings {
  std::string input, output, flow, curvature;
  int k, iterations, update_period, threads; // signed, so that -1 is refused and not 4294967295
  double neighbor_radius, sharpness_angle, feature_threshold, filter_width, step_length;
  bool normals, quiet, with_feature_threshold;
  bool automatic; // none of the numbers of the flow is given
};

/// Reads the command line; empty if there is nothing to do after it.
std::optional<Settings> read_command_line(int argc, char** argv)
{
  Settings s;
  options::options_description description(
      "Usage: smooth_point_set input output [options]\n\n"
      "Smooths a point set by dynamic balanced flow. Formats: PLY, XYZ (also PWN, TXT, PTS), OFF,\n"
      "and LAS where CGAL has it. All other properties of the points are kept.\n\nOptions");
  // clang-format off
  description.add_options()
    ("help,h", "print this text")
    ("neighbors,k", options::value(&s.k)->default_value(0), "neighborhood size, 0: chosen from the data")
    ("neighbor-radius", options::value(&s.neighbor_radius)->default_value(0.), "no neighbors beyond it, 0: no limit")
    ("iterations", options::value(&s.iterations), "number of iterations, by default as many as suit the estimator")
    ("sharpness-angle", options::value(&s.sharpness_angle),
     "creases from this angle on, in degrees, are features")
    ("feature-threshold", options::value(&s.feature_threshold), "K of the paper instead of the sharpness angle")
    ("filter-width", options::value(&s.filter_width),
     "sigma of the Gaussians, in neighborhood radii")
    ("step-length", options::value(&s.step_length), "s of the paper")
    ("update-period", options::value(&s.update_period)->default_value(4),
     "L of the paper, 0: the reference is never updated")
    ("flow", options::value(&s.flow)->default_value("balanced"),
     "curvature, anisotropic, well-posed, volume-preserving or balanced")
    ("curvature", options::value(&s.curvature)->default_value("tangent-plane"),
     "the estimator: tangent-plane, or covariance, which is the paper's")
    ("normals", options::bool_switch(&s.normals), "write normals even if the input has none")
    ("threads", options::value(&s.threads)->default_value(0), "number of threads, 0: all")
    ("quiet,q", options::bool_switch(&s.quiet), "no progress bar, no summary");
  options::options_description files;
  files.add_options()("input", options::value(&s.input)->required(), "")
                     ("output", options::value(&s.output)->required(), "");
  // clang-format on
  options::positional_options_description positions;
  positions.add("input", 1).add("output", 1);

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
  if (s.k < 0 || s.threads < 0)
    throw std::invalid_argument("--neighbors and --threads must not be negative");
  if (s.curvature != "tangent-plane" && s.curvature != "covariance")
    throw std::invalid_argument("there is no estimator \"" + s.curvature + "\"");
  s.with_feature_threshold = given.count("feature-threshold") != 0;
  s.automatic = s.curvature == "tangent-plane" && !s.with_feature_threshold;
  const flows::Curvature_defaults defaults = s.curvature == "covariance"
                                                 ? flows::Curvature_defaults()
                                                 : flows::Tangent_plane_curvature::defaults();
  const auto fill = [&](const char* name, auto& value, auto otherwise) {
    if (given.count(name))
      s.automatic = false;
    else
      value = otherwise;
  };
  fill("iterations", s.iterations, int(defaults.number_of_iterations));
  fill("sharpness-angle", s.sharpness_angle, defaults.sharpness_angle);
  fill("filter-width", s.filter_width, defaults.filter_width);
  fill("step-length", s.step_length, defaults.step_length);
  return s;
}

/// All flows as one type, which keeps the program small
typedef std::function<flows::Vector_3(const flows::Flow_point_3&, const flows::Diffusivity&)> Flow;

Flow find_flow(const std::string& name)
{
  if (name == "curvature")
    return flows::Curvature_flow();
  if (name == "anisotropic")
    return flows::Anisotropic_flow();
  if (name == "well-posed")
    return flows::Well_posed_anisotropic_flow();
  if (name == "volume-preserving")
    return flows::Volume_preserving_flow();
  if (name == "balanced")
    return flows::Balanced_flow();
  throw std::invalid_argument("there is no flow \"" + name + "\"");
}

template <typename Concurrency_tag>
double smooth(Point_set& points, const Settings& s)
{
  const auto call = [&](const auto& parameters) {
    return s.k != 0 ? CGAL::balanced_flow_smooth_point_set<Concurrency_tag>(
                          points, static_cast<unsigned int>(s.k), parameters)
                    : CGAL::balanced_flow_smooth_point_set<Concurrency_tag>(points, parameters);
  };
  const Progress_bar progress(!s.quiet && isatty(STDERR_FILENO));
  const auto own = CGAL::parameters::flow(find_flow(s.flow)).update_period(s.update_period);
  if (s.automatic)
    return call(own.neighbor_radius(s.neighbor_radius).callback(progress));
  const auto by_hand = [&](const auto& parameters) {
    const auto run = [&](const auto& all) {
      return call(all.number_of_iterations(s.iterations)
                      .sharpness_angle(s.sharpness_angle)
                      .neighbor_radius(s.neighbor_radius)
                      .callback(progress));
    };
    return s.with_feature_threshold ? run(parameters.feature_threshold(s.feature_threshold))
                                    : run(parameters);
  };
  const auto numbers = own.filter_width(s.filter_width).step_length(s.step_length);
  return s.curvature == "covariance" ? by_hand(numbers.curvature(flows::Covariance_curvature()))
                                     : by_hand(numbers);
}

template <typename Concurrency_tag>
int run(const Settings& s)
{
  check_output(s.output);
  Point_set_file file = read_point_set_file(s.input);
  Point_set& points = file.points;
  if (s.normals && !points.has_normal_map())
    points.add_normal_map(CGAL::NULL_VECTOR);
  const std::vector<Kernel::Point_3> before(points.points().begin(), points.points().end());

  CGAL::Real_timer timer;
  timer.start();
  const flows::Point_set_scale scale = flows::estimate_point_set_scale<Concurrency_tag>(points);
  const double moved = smooth<Concurrency_tag>(points, s);
  timer.stop();
  if (interrupted || !write_point_set_file(s.output, file, interrupted)) {
    std::cerr << "\ninterrupted, nothing written" << std::endl;
    return INTERRUPTED;
  }

  if (!s.quiet) {
    double total = 0.;
    for (const Point_set::Index& i : points)
      total += std::sqrt(CGAL::squared_distance(before[i], points.point(i)));
    std::cout << "points            " << points.size() << "\n"
              << "spacing           " << scale.spacing << "\n"
              << "estimated noise   " << scale.noise << "\n"
              << "neighbors         " << (s.k != 0 ? std::to_string(s.k) : "chosen for each point")
              << "\n"
              << "mean movement     " << total / double(points.size())
              << " (last iteration: " << moved << ")\n"
              << "seconds           " << timer.time() << std::endl;
  }
  return SUCCESS;
}

} // namespace

int main(int argc, char** argv)
{
  std::signal(SIGINT, on_interrupt);
  try {
    const std::optional<Settings> settings = read_command_line(argc, argv);
    if (!settings)
      return SUCCESS;
#ifdef CGAL_LINKED_WITH_TBB
    std::optional<tbb::global_control> limit;
    if (settings->threads != 0)
      limit.emplace(tbb::global_control::max_allowed_parallelism,
                    static_cast<std::size_t>(settings->threads));
#endif
    return settings->threads == 1 ? run<CGAL::Sequential_tag>(*settings)
                                  : run<CGAL::Parallel_if_available_tag>(*settings);
  }
  catch (const options::error& e) { // what is wrong with the command line
    std::cerr << "smooth_point_set: " << e.what() << " (see --help)" << std::endl;
    return BAD_USAGE;
  }
  catch (const std::invalid_argument& e) { // a value that the library refuses
    std::cerr << "smooth_point_set: " << e.what() << std::endl;
    return BAD_USAGE;
  }
  catch (const std::exception& e) {
    std::cerr << "smooth_point_set: " << e.what() << std::endl;
    return BAD_FILE;
  }
}
