// SPDX-License-Identifier: GPL-3.0-or-later
// How long this package takes and how much memory it needs, beside one pass of the smoothers of CGAL,
// and its neighbor graph beside those of others. Each run has a process of its own; the methods take
// turns, and medians are printed. Ratios are what to trust. The error is that of at most two million points.
//   benchmark_speed [--points ...] [--orders ...] [--samplings ...] [--threads ...] [--methods ...]
#include "Speed_clouds.h"
#include "Speed_machine.h"
#include "Speed_methods.h"
#include "Speed_phases.h"

#include "measure/run_in_child.h"

#include <boost/program_options.hpp>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <fstream>

using namespace comparison;

namespace options = boost::program_options;

namespace {

typedef std::vector<std::string> Names;

struct Settings {
  Names methods, orders, samplings;
  std::vector<std::size_t> points;
  std::vector<unsigned int> threads;
  unsigned int repeats;
  std::string csv;
  bool difficult, phases, machine;
};

std::optional<Settings> read_command_line(int argc, char** argv)
{
  Settings s;
  options::options_description description("Options");
  // clang-format off
  description.add_options()
    ("help,h", "print this text")
    ("points", options::value(&s.points)->multitoken()->default_value({1000000}, "1000000"), "numbers of points")
    ("orders", options::value(&s.orders)->multitoken()->default_value({"unordered", "ordered"}, "unordered ordered"), "of the input")
    ("samplings", options::value(&s.samplings)->multitoken()->default_value({"uniform"}, "uniform"), "uniform, scan")
    ("threads", options::value(&s.threads)->multitoken()->default_value({1}, "1"), "numbers of threads")
    ("methods", options::value(&s.methods)->multitoken(), "only these")
    ("repeats", options::value(&s.repeats)->default_value(3), "runs of each")
    ("csv", options::value(&s.csv), "file for all numbers")
    ("difficult", options::bool_switch(&s.difficult), "duplicates, lines and far points instead")
    ("phases", options::bool_switch(&s.phases), "the phases of our run instead")
    ("machine", options::bool_switch(&s.machine), "what one thread of this machine can do instead");
  // clang-format on
  options::variables_map given;
  options::store(options::parse_command_line(argc, argv, description), given);
  if (given.count("help")) {
    std::cout << "Usage: benchmark_speed [options]\n\n" << description;
    return std::nullopt;
  }
  options::notify(given);
  if (s.repeats == 0)
    throw std::invalid_argument("--repeats needs a positive number");
  return s;
}

bool is_search(const std::string& method)
{
  return method == "Neighbor_query" || method == "nanoflann" || method == "our graph";
}

/// One run in a process of its own, of points that it may change: they are its copy.
std::optional<Run> run_method(const std::string& name, Points& points, unsigned int threads)
{
  const auto smooth = [&]() {
#ifdef CGAL_LINKED_WITH_TBB
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    const auto methods =
        threads > 1 ? speed_methods<CGAL::Parallel_tag>() : speed_methods<CGAL::Sequential_tag>();
#else
    const auto methods = speed_methods<CGAL::Sequential_tag>();
#endif
    methods.at(name)(points);
    const std::size_t most_measured = 2000000; // they pass through a pipe
    Smoothed smoothed;
    if (points.size() <= most_measured && !is_search(name))
      smoothed.points = std::move(points);
    return smoothed;
  };
  // pages that the process shares with this one are slow when they are first written
  const auto touch = [&]() {
    for (int i = 0; i < 2; ++i)
      std::reverse(points.begin(), points.end());
  };
  return run_in_child(smooth, touch);
}

class Benchmark {
  struct Result {
    double seconds, bytes, error;
  };
  typedef std::map<std::string, Result> Results;

  static constexpr double not_measured = std::numeric_limits<double>::quiet_NaN();
  const Settings& m_settings;
  std::ofstream m_csv;

  Names wanted_methods() const
  {
    Names names;
    for (const auto& method : speed_methods<CGAL::Sequential_tag>())
      if (m_settings.methods.empty() ||
          std::find(m_settings.methods.begin(), m_settings.methods.end(), method.first) !=
              m_settings.methods.end())
        names.push_back(method.first);
    return names;
  }

  Results measure(Points& points, const Names& methods, unsigned int threads) const
  {
    std::map<std::string, std::vector<double>> seconds, bytes;
    Results results;
    for (unsigned int i = 0; i < m_settings.repeats; ++i)
      for (const std::string& method : methods)
        if (const std::optional<Run> run = run_method(method, points, threads)) {
          seconds[method].push_back(run->seconds);
          bytes[method].push_back(run->megabytes * 1024. * 1024. / double(points.size()));
          results[method].error = run->smoothed.points.empty() ? not_measured
                                                               : rms_error(run->smoothed.points);
        }
    for (auto& [method, result] : results) {
      result.seconds = median(seconds[method]);
      result.bytes = median(bytes[method]);
    }
    return results;
  }

  /// \param smaller sizes and times of before
  void print(const std::string& cloud, std::size_t n, unsigned int threads, const Results& results,
             std::map<std::string, std::pair<std::size_t, double>>& smaller)
  {
    for (const auto& [method, result] : results) {
      const auto ours = results.find(is_search(method) ? "our graph" : "ours");
      const double ratio =
          ours == results.end() ? not_measured : ours->second.seconds / result.seconds;
      const auto before = smaller.find(method);
      const double growth = before == smaller.end()
                                ? not_measured
                                : std::log(result.seconds / before->second.second) /
                                      std::log(double(n) / double(before->second.first));
      std::printf("| %s | %zu | %u | %s | %.3f | %.0f | %.0f | %.2f | **%.3f** | %.3f |\n",
                  cloud.c_str(), n, threads, method.c_str(), result.seconds,
                  1e9 * result.seconds / double(n), result.bytes, growth, ratio, result.error);
      if (m_csv.is_open())
        m_csv << cloud << ',' << n << ',' << threads << ',' << method << ',' << result.seconds
              << ',' << result.bytes << ',' << result.error << std::endl;
      smaller[method] = {n, result.seconds};
    }
    std::fflush(stdout);
  }

  void run_clouds()
  {
    std::printf("| cloud | points | threads | method | seconds | ns per point | peak bytes per point | "
                "growth | ours to it | rms error in spacings |\n|---|---|---|---|---|---|---|---|---|---|\n");
    const Names methods = wanted_methods();
    for (const std::string& sampling : m_settings.samplings)
      for (const std::string& order : m_settings.orders)
        for (const unsigned int threads : m_settings.threads) {
          std::map<std::string, std::pair<std::size_t, double>> smaller;
          for (const std::size_t n : m_settings.points) {
            Points points = bumpy_sphere(sampling, n);
            put_in_order(points, order);
            print(sampling + ' ' + order, n, threads, measure(points, methods, threads), smaller);
          }
        }
  }

  void run_phases() const
  {
    std::printf("| order | points | threads | phase | seconds | ns per point | share | longest "
                "between two calls of the callback |\n|---|---|---|---|---|---|---|---|\n");
    for (const std::string& order : m_settings.orders)
      for (const std::size_t n : m_settings.points)
        for (const unsigned int threads : m_settings.threads) {
          Points points = bumpy_sphere("uniform", n);
          put_in_order(points, order);
          std::vector<Phases> runs;
          for (unsigned int i = 0; i < m_settings.repeats; ++i)
            runs.push_back(measure_phases(points, threads));
          const Phases phases = median_phases(runs);
          double total = 0.;
          for (const Phase& phase : phases)
            total += phase.seconds;
          for (const Phase& phase : phases)
            std::printf("| %s | %zu | %u | %s | %.3f | %.0f | %.0f%% | %.3f |\n", order.c_str(), n,
                        threads, phase.name.c_str(), phase.seconds, 1e9 * phase.seconds / double(n),
                        100. * phase.seconds / total, phase.interval);
          std::fflush(stdout);
        }
  }

  void run_machine() const
  {
    double sink = 0.;
    std::printf("| copied, read and written | %.1f GB/s |\n", 1e-9 * bytes_per_second());
    std::printf("| multiplications and additions of floats | %.1f Gflop/s |\n",
                1e-9 * flops_per_second(sink));
    if (!std::isfinite(sink))
      throw std::runtime_error("the arithmetic of this machine is wrong");
  }

  void run_difficult_clouds() const
  {
    std::printf("| cloud | points | seconds | to the ordinary one |\n|---|---|---|---|\n");
    for (const std::size_t n : m_settings.points) {
      double ordinary = 0.;
      for (const char* kind : {"ordinary", "identical points", "points on a line",
                               "each point ten times", "a point far away",
                               "a plane and a point far away", "points over 40 decades"}) {
        Points points = difficult_cloud(kind, n);
        const double seconds =
            measure(points, {"ours"}, m_settings.threads.front()).at("ours").seconds;
        if (ordinary == 0.)
          ordinary = seconds;
        std::printf("| %s | %zu | %.3f | **%.2f** |\n", kind, n, seconds, seconds / ordinary);
        std::fflush(stdout);
      }
    }
  }

public:
  explicit Benchmark(const Settings& settings) : m_settings(settings)
  {
    if (settings.csv.empty())
      return;
    m_csv.open(settings.csv);
    if (!m_csv)
      throw std::runtime_error("cannot write " + settings.csv);
    m_csv << "cloud,points,threads,method,seconds,bytes per point,rms error" << std::endl;
  }

  void run()
  {
    if (m_settings.machine)
      run_machine();
    else if (m_settings.phases)
      run_phases();
    else if (m_settings.difficult)
      run_difficult_clouds();
    else
      run_clouds();
  }
};

} // namespace

int main(int argc, char** argv)
{
  try {
    const std::optional<Settings> settings = read_command_line(argc, argv);
    if (settings)
      Benchmark(*settings).run();
    return EXIT_SUCCESS;
  }
  catch (const std::exception& error) {
    std::cerr << "benchmark_speed: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }
}
