// SPDX-License-Identifier: GPL-3.0-or-later
#include "Command_line.h"

#include "check_paths.h"
#include "parse_options.h"
#include "point_files/Layout.h"

#include <CGAL/Point_set_flow/Covariance_curvature.h>
#include <CGAL/Point_set_flow/Tangent_plane_curvature.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <sstream>

namespace balanced_flow_smooth {

namespace flows = CGAL::Point_set_flow;
namespace options = boost::program_options;

namespace {

std::vector<std::string> names_of_formats()
{
  std::vector<std::string> names;
  for (const point_files::Format& format : point_files::all_formats())
    names.push_back(format.name);
  return names;
}

/// "a, b or c"
std::string alternatives(const std::vector<std::string>& values)
{
  std::string text;
  for (std::size_t i = 0; i < values.size(); ++i)
    text += (i == 0 ? "" : i + 1 == values.size() ? " or " : ", ") + values[i];
  return text;
}

} // namespace

const std::map<std::string, std::vector<std::string>>& choices()
{
  static const std::map<std::string, std::vector<std::string>> table = {
      {"flow", {"curvature", "anisotropic", "well-posed", "volume-preserving", "balanced"}},
      {"curvature", {"tangent-plane", "covariance"}},
      {"format", names_of_formats()},
      {"output-format", names_of_formats()},
      {"print-completion", {"bash", "zsh", "fish"}},
  };
  return table;
}

Command_line::Command_line()
{
  add_file_options(groups.emplace_back("Files"));
  add_report_options(groups.emplace_back("What to tell"));
  add_smoothing_options(groups.emplace_back("Smoothing"));
  add_hidden_options(hidden);
}

// clang-format off
void Command_line::add_file_options(Option_group& group)
{
  group.add_options()
    ("in-place,i", options::bool_switch(&m_in_place), "replace each file by its smoothed points")
    ("output-dir,d", options::value(&m_output_directory)->value_name("DIR"),
     "write to files of the same names in DIR, which is not the directory of the input")
    ("format", options::value(&m_format)->value_name("FORMAT"),
     ("the format of all inputs, whatever their names: " + alternatives(names_of_formats())).c_str())
    ("output-format", options::value(&m_output_format)->value_name("FORMAT"),
     "the format of the output, whatever its name; files in DIR get its extension; "
     "by default that of the input for - and DIR")
    ("columns", options::value(&m_columns)->value_name("NAMES"),
     "what the columns of text are, whatever its header says, for instance x,y,z,nx,ny,nz or x,y,z,_,intensity; _ or "
     "nothing: no name, and so are those that are left")
    ("normals", options::bool_switch(&m_settings.normals),
     "write normals even if the input has none, or some that are null vectors or NaN, which else stay");
}

void Command_line::add_report_options(Option_group& group)
{
  group.add_options()
    ("dry-run,n", options::bool_switch(&m_settings.dry_run),
     "write no points; tell spacing, noise and the parameters that would be used")
    ("json", options::value(&m_settings.report)->implicit_value(json_without_file)->value_name("FILE"),
     "write the report as JSON, to FILE if it is given (--json=FILE), else to standard output in place of the summary")
    ("quiet,q", options::bool_switch(&m_settings.quiet), "no progress bar, no summary, no warnings")
    ("help,h", "print this text")
    ("version", "print the version");
}

void Command_line::add_smoothing_options(Option_group& group)
{
  Smoothing_settings& s = m_settings.smoothing;
  group.add_options()
    ("noise", options::value(&m_noise)->value_name("LENGTH"),
     "standard deviation of the noise along the normals, in the unit of the data; by default estimated around each "
     "point. It replaces the estimate; with 0 nothing moves")
    ("neighbors,k", options::value(&m_k)->value_name("N"),
     "number of neighbors, 0: chosen for each point from the data, which is the default")
    ("neighbor-radius", options::value(&s.neighbor_radius)->value_name("LENGTH"),
     "no neighbors beyond it, 0: no limit, which is the default")
    ("iterations", options::value(&m_iterations)->value_name("N"),
     "number of iterations, by default as many as suit the estimator, 5 or 12")
    ("sharpness-angle", options::value(&s.sharpness_angle)->value_name("DEGREES"),
     "creases from this angle on are features; by default 60, or 30 for the estimator of the paper")
    ("feature-threshold", options::value(&m_feature_threshold)->value_name("K"),
     "K of the paper instead of the sharpness angle")
    ("filter-width", options::value(&m_filter_width)->value_name("SIGMA"),
     "width of the Gaussians, in neighborhood radii; by default 0.6, or 0.3")
    ("step-length", options::value(&s.step_length)->value_name("S"), "s of the paper; by default 0.75")
    ("update-period", options::value(&m_update_period)->value_name("L"),
     "L of the paper, by default 4; 0: the reference is never updated")
    ("flow", options::value(&s.flow)->value_name("FLOW"),
     "curvature, anisotropic, well-posed, volume-preserving or balanced, which is the default")
    ("curvature", options::value(&s.curvature)->value_name("ESTIMATOR"),
     "tangent-plane, which is the default, or covariance, the estimator of the paper")
    ("threads", options::value(&m_threads)->value_name("N"), "number of threads, 0: all, which is the default");
}

void Command_line::add_hidden_options(Option_group& group)
{
  group.add_options()
    ("print-man", options::value<std::string>()->implicit_value(man_without_date)->value_name("DATE"), "print the manual page")
    ("print-completion", options::value<std::string>()->value_name("SHELL"), "print the completion for a shell")
    ("file", options::value(&m_files), "");
}
// clang-format on

void Command_line::read(int argc, char** argv)
{
  Option_group all;
  for (const Option_group& group : groups)
    all.add(group);
  all.add(hidden);
  try {
    options::store(parse_options(argc, argv, all, "file"), m_given);
    options::notify(m_given);
  }
  catch (const options::error& e) {
    throw Usage_error(e.what());
  }
  for (const auto& [option, values] : choices())
    if (has(option.c_str()) &&
        std::find(values.begin(), values.end(), text(option.c_str())) == values.end())
      throw Usage_error("there is no " + option + " \"" + text(option.c_str()) + "\"");
}

Settings Command_line::settings()
{
  for (const char* count : {"neighbors", "iterations", "update-period", "threads"})
    if (has(count) && m_given[count].as<int>() < 0)
      throw Usage_error("--" + std::string(count) + " must not be negative");
  m_settings.threads = unsigned(m_threads);
  m_settings.input_format = point_files::find_format(m_format);
  m_settings.output_format = point_files::find_format(m_output_format);
  set_columns();
  set_smoothing();
  set_jobs();
  if (m_settings.report == "-" && m_settings.points_to_standard_output())
    throw Usage_error("the points go to standard output, so the report can not: use --json=FILE");
  check_paths(m_settings);
  return m_settings;
}

void Command_line::set_columns()
{
  if (!has("columns"))
    return;
  std::istringstream names(m_columns);
  for (std::string name; std::getline(names, name, ',');)
    m_settings.columns.push_back(name);
  try {
    const point_files::Layout layout(m_settings.columns);
  }
  catch (const std::exception& e) {
    throw Usage_error("--columns is \"" + m_columns + "\": " + e.what());
  }
}

void Command_line::set_smoothing()
{
  Smoothing_settings& s = m_settings.smoothing;
  s.fills_normals = m_settings.normals;
  const flows::Curvature_defaults defaults = s.is_paper_estimator()
                                                 ? flows::Curvature_defaults()
                                                 : flows::Tangent_plane_curvature::defaults();
  if (m_k != 0)
    s.k = unsigned(m_k);
  s.iterations = has("iterations") ? unsigned(m_iterations) : defaults.number_of_iterations;
  s.update_period = unsigned(m_update_period);
  if (!has("sharpness-angle"))
    s.sharpness_angle = defaults.sharpness_angle;
  if (!has("step-length"))
    s.step_length = defaults.step_length;
  if (has("noise")) {
    if (!(m_noise >= 0.)) {
      std::ostringstream message;
      message << "--noise is " << m_noise
              << ", but must not be negative; without it the noise is estimated";
      throw Usage_error(message.str());
    }
    s.noise = m_noise;
  }
  if (has("feature-threshold"))
    s.feature_threshold = m_feature_threshold;
  if (has("filter-width"))
    s.filter_width = m_filter_width;
}

void Command_line::set_jobs()
{
  const bool to_directory = has("output-dir");
  if (m_files.empty())
    throw Usage_error("a file is required");
  if (m_in_place && to_directory)
    throw Usage_error("--in-place and --output-dir exclude each other");
  if (m_in_place || to_directory) {
    add_job_for_each_file();
    if (m_in_place && m_settings.output_format)
      throw Usage_error("a file keeps its format in place");
  }
  else if (m_files.size() == 2)
    m_settings.jobs = {{m_files[0], m_files[1], m_files[1] == "-"}};
  else if (m_files.size() == 1 && m_settings.dry_run)
    m_settings.jobs = {{m_files[0], "", true}};
  else if (m_files.size() == 1)
    throw Usage_error("an output is required: a file, -, --in-place or --output-dir");
  else
    throw Usage_error("more than two files need --in-place or --output-dir");
}

/// Each file becomes one in place or in the output directory.
void Command_line::add_job_for_each_file()
{
  for (const std::string& file : m_files) {
    if (file == "-")
      throw Usage_error("standard input has no place or name: write to - or a file");
    m_settings.jobs.push_back(
        {file, m_in_place ? std::filesystem::path(file) : in_directory(file), true});
  }
}

std::filesystem::path Command_line::in_directory(const std::filesystem::path& file) const
{
  if (!std::filesystem::is_directory(m_output_directory))
    throw Usage_error("there is no directory " + m_output_directory);
  std::filesystem::path output = std::filesystem::path(m_output_directory) / file.filename();
  if (m_settings.output_format)
    output.replace_extension("." + m_settings.output_format->name);
  return output;
}

} // namespace balanced_flow_smooth
