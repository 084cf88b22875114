// SPDX-License-Identifier: GPL-3.0-or-later
// Smooths the points of files and keeps everything else in them.
#include "Interrupt.h"
#include "Progress_bar.h"
#include "Report.h"
#include "command_line/Command_line.h"
#include "command_line/Manual.h"
#include "command_line/print_completion.h"
#include "command_line/print_manual.h"
#include "memory_use.h"
#include "point_files/invalid_points.h"
#include "point_files/point_file_io.h"
#include "smooth.h"
#include "smooth_in_blocks.h"

#include <CGAL/Real_timer.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <iostream>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <vector>

using namespace balanced_flow_smooth;

namespace {

enum Exit_code { SUCCESS = 0, BAD_USAGE = 1, BAD_FILE = 2, SIGNALLED = 128 };

void complain(const std::string& what) { std::cerr << program_name << ": " << what << std::endl; }

std::unique_ptr<point_files::Point_file> read(const std::filesystem::path& input,
                                              const Settings& settings)
{
  const Nothing_at_stake nothing_at_stake;
  return point_files::read_point_file(
      input, settings.input_format,
      {settings.normals, settings.columns, settings.invalid, settings.zeros_are_invalid});
}

/// Smooths one file that may be larger than the memory.
/// \return whether it is done: it is not after Ctrl-C
bool run_in_blocks(const Settings& settings, File_report& report)
{
  CGAL::Real_timer timer;
  timer.start();
  Progress_bar progress(!settings.quiet && isatty(STDERR_FILENO));
  if (!balanced_flow_blocks::smooth_in_blocks(settings, report, std::ref(progress)))
    return false;
  report.seconds = timer.time();
  return true;
}

/// Smooths one file.
/// \return whether it is done: it is not after Ctrl-C
bool run(const Settings& settings, File_report& report)
{
  if (!settings.memory.empty())
    return run_in_blocks(settings, report);
  const auto& [input, output, keeps_format] = report.job;
  const point_files::Format* output_format = settings.output_format;
  if (!output_format && !keeps_format)
    output_format = &point_files::format_of(output);
  if (!settings.dry_run)
    point_files::check_output(output, output_format);
  const std::unique_ptr<point_files::Point_file> file = read(input, settings);
  if (!output_format)
    output_format = file->format;
  report.format = file->format->name;
  report.output_format = output_format->name;
  report.points = file->points.size() - file->invalid.size();
  report.invalid_points = file->invalid.size();
  report.drops_invalid = file->drops_invalid;
  report.normals = settings.normals || !file->normals.empty();
  report.unknown_normals = std::size_t(std::count_if(file->normals.begin(), file->normals.end(),
                                                     [](const auto& n) { return !is_known(n); }));
  report.roles = file->roles;
  report.roles_source = file->roles_source;

  if (settings.normals)
    file->add_normals(settings.smoothing.makes_steps());

  point_files::Set_aside invalid_points(*file);
  CGAL::Real_timer timer;
  timer.start();
  const Progress_bar progress(!settings.quiet && isatty(STDERR_FILENO));
  Smoothing_report smoothing;
  if (settings.dry_run)
    smoothing = analyze(file->points, settings.smoothing, progress);
  else
    smooth(file->points, file->normals.empty() ? file->sides : file->normals, settings.smoothing,
           progress, smoothing);
  if (interrupt != 0)
    return false;
  invalid_points.put_back();
  report.smoothing = smoothing;
  if (!settings.dry_run)
    point_files::warn_of_losses(*file, *output_format);
  report.warnings = file->warnings;
  if (!settings.quiet)
    for (const std::string& warning : report.warnings)
      std::cerr << "warning: " << warning << std::endl;
  if (!settings.dry_run &&
      !point_files::write_point_file(output, *file, *output_format, [] { return interrupt != 0; }))
    return false;
  report.seconds = timer.time();
  return true;
}

/// Smooths all files, as far as it goes.
int run_all(const Settings& settings)
{
  int code = SUCCESS;
  std::vector<File_report> reports;
  for (const Job& job : settings.jobs) {
    File_report& report = reports.emplace_back();
    report.job = job;
    try {
      if (!run(settings, report)) {
        report.status = "interrupted";
        std::cerr << "\ninterrupted, nothing written" << std::endl;
        code = SIGNALLED + interrupt;
        break;
      }
      if (!settings.quiet && settings.report != "-")
        print_summary(settings.points_to_standard_output() ? std::cerr : std::cout, report,
                      settings);
    }
    catch (const std::exception& e) {
      report.status = "failed";
      report.message = dynamic_cast<const std::bad_alloc*>(&e)
                           ? job.input.string() + ": not enough memory"
                           : std::string(e.what());
      complain(report.message);
      code = BAD_FILE;
    }
  }
  if (!settings.report.empty())
    write_json(reports, settings);
  return code;
}

/// Prints what was asked for in place of smoothing.
/// \return whether anything was
bool print_information(const Command_line& command_line)
{
  if (command_line.has("help"))
    print_help(std::cout, manual::page(), command_line);
  else if (command_line.has("version"))
    std::cout << program_name << ' ' << POINT_SET_FLOW_VERSION << std::endl;
  else if (command_line.has("print-man"))
    print_manual_page(std::cout, manual::page(), command_line, command_line.text("print-man"));
  else if (command_line.has("print-completion"))
    print_completion(std::cout, command_line, {program_name, {}},
                     command_line.text("print-completion"));
  else
    return false;
  return true;
}

} // namespace

int main(int argc, char** argv)
{
  std::ios::sync_with_stdio(false);
  listen_for_interrupts();
  try {
    Command_line command_line;
    command_line.read(argc, argv);
    if (print_information(command_line))
      return SUCCESS;
    const Settings settings = command_line.settings();
#ifdef CGAL_LINKED_WITH_TBB
    std::optional<tbb::global_control> limit;
    if (settings.threads != 0)
      limit.emplace(tbb::global_control::max_allowed_parallelism, settings.threads);
#endif
    check(settings.smoothing);
    balanced_flow_blocks::memory_from_text(settings.memory); // before any work
    return run_all(settings);
  }
  catch (const Usage_error& e) {
    complain(e.what() + std::string(" (see --help)"));
    return BAD_USAGE;
  }
  catch (const std::invalid_argument& e) { // a value that the library refuses
    complain(e.what());
    return BAD_USAGE;
  }
  catch (const std::exception& e) {
    complain(e.what());
    return BAD_FILE;
  }
}
