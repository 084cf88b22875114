// SPDX-License-Identifier: GPL-3.0-or-later
#include "Command_line.h"

#include "check_paths.h"
#include "parse_options.h"
#include "point_files/Layout.h"

#include <CGAL/Point_set_flow/Covariance_curvature.h>
#include <CGAL/Point_set_flow/Learned_curvature.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <sstream>

namespace balanced_flow_smooth {

namespace flows = CGAL::Point_set_flow;
namespace options = boost::program_options;

Command_line::Command_line()
{
  add_file_options(groups.emplace_back("Files"));
  add_report_options(groups.emplace_back("What to tell"));
  add_smoothing_options(groups.emplace_back("Smoothing"));
  add_memory_options(groups.emplace_back("Beyond memory"));
  add_hidden_options(hidden);
}

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
  settings_without_jobs();
  set_jobs();
  if (m_settings.report == "-" && m_settings.points_to_standard_output())
    throw Usage_error("the points go to standard output, so the report can not: use --json=FILE");
  check_memory();
  check_paths(m_settings);
  return m_settings;
}

Settings Command_line::settings_without_jobs()
{
  for (const char* count : {"neighbors", "iterations", "update-period", "relax", "threads"})
    if (has(count) && m_given[count].as<int>() < 0)
      throw Usage_error("--" + std::string(count) + " must not be negative");
  if (m_jobs < 1 || m_jobs > 1024)
    throw Usage_error("--jobs must be a number from 1 to 1024");
  if (has("block-size") && m_block_size < 1)
    throw Usage_error("--block-size must be positive");
  m_settings.processes = unsigned(m_jobs);
  m_settings.block_size = std::size_t(m_block_size);
  m_settings.threads = unsigned(m_threads);
  m_settings.input_format = point_files::find_format(m_format);
  m_settings.output_format = point_files::find_format(m_output_format);
  set_columns();
  if (has("invalid"))
    m_settings.invalid = m_invalid == "keep"   ? point_files::Invalid::KEEP
                         : m_invalid == "drop" ? point_files::Invalid::DROP
                                               : point_files::Invalid::ERROR;
  set_smoothing();
  return m_settings;
}

/// Points that are not all in memory are read twice, and keep format and number.
void Command_line::check_memory() const
{
  if (m_settings.memory.empty()) {
    if (has("jobs") || has("block-size"))
      throw Usage_error("--jobs and --block-size need --memory");
    return;
  }
  for (const char* option : {"output-format", "normals", "dry-run", "together"})
    if (has(option) && !m_given[option].defaulted())
      throw Usage_error("--memory and --" + std::string(option) + " exclude each other");
  if (m_settings.invalid == point_files::Invalid::DROP)
    throw Usage_error("with --memory, invalid points can be kept only");
  for (const Job& job : m_settings.jobs)
    if (job.input == "-" || job.output == "-")
      throw Usage_error("with --memory, input and output are files");
    else if (!job.keeps_format && job.input.extension() != job.output.extension())
      throw Usage_error("with --memory, files keep their format");
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
                                                 : flows::Learned_curvature::defaults();
  if (m_k != 0)
    s.k = unsigned(m_k);
  s.iterations = has("iterations") ? unsigned(m_iterations) : defaults.number_of_iterations;
  s.update_period = unsigned(m_update_period);
  s.relaxation_steps = unsigned(m_relaxation_steps);
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
  else if (m_settings.together && m_settings.dry_run)
    for (const std::string& file : m_files)
      m_settings.jobs.push_back({file, "", true});
  else if (m_settings.together)
    throw Usage_error(
        "--together needs --in-place or --output-dir, since each file is written back");
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
