// SPDX-License-Identifier: GPL-3.0-or-later
// Smooths the points of files and keeps everything else in them.
#include "Command_line.h"
#include "Interrupt.h"
#include "Report.h"
#include "point_file_io.h"
#include "print_completion.h"
#include "print_manual.h"
#include "smooth.h"

#include <CGAL/Real_timer.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <unistd.h>

#include <iostream>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <vector>

namespace {

enum Exit_code { SUCCESS = 0, BAD_USAGE = 1, BAD_FILE = 2, SIGNALLED = 128 };

void complain(const std::string& what) { std::cerr << program_name << ": " << what << std::endl; }

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
    return interrupt == 0;
  }
};

/// Smooths one file.
/// \return whether it is done: it is not after Ctrl-C
bool run(const Settings& settings, File_report& report)
{
  const auto& [input, output, keeps_format] = report.job;
  std::optional<Format> format = settings.input_format, output_format = settings.output_format;
  if (!output_format && !keeps_format)
    output_format = format_of(output);
  if (!settings.dry_run)
    check_output(output, output_format);
  const std::unique_ptr<Point_file> file = read_point_file(input, format, settings.normals);
  if (!output_format)
    output_format = format;
  report.format = name_of(*format);
  report.output_format = name_of(*output_format);
  report.points = file->points.size();
  if (settings.normals)
    file->add_normals();
  report.normals = !file->normals.empty();

  CGAL::Real_timer timer;
  timer.start();
  if (!settings.quiet || !settings.report.empty() || settings.dry_run) {
    report.parameters = find_parameters(file->points, settings.smoothing, Progress_bar(false));
    if (!report.parameters)
      return false;
  }
  if (!settings.dry_run) {
    const Progress_bar progress(!settings.quiet && isatty(STDERR_FILENO));
    const double moved = smooth(file->points, file->normals, settings.smoothing, progress);
    if (interrupt != 0)
      return false;
    if (report.parameters) {
      report.mean_movement = file->mean_movement();
      report.last_movement = moved;
    }
    warn_of_losses(*file, *format, *output_format);
    report.warnings = file->warnings;
    if (!settings.quiet)
      for (const std::string& warning : report.warnings)
        std::cerr << "warning: " << warning << std::endl;
    if (!write_point_file(output, *file, *format, *output_format))
      return false;
  }
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
                      settings.smoothing, settings.jobs.size() > 1);
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

} // namespace

int main(int argc, char** argv)
{
  std::ios::sync_with_stdio(false);
  listen_for_interrupts();
  try {
    Command_line command_line;
    command_line.read(argc, argv);
    if (command_line.has("help") || command_line.has("version") || command_line.has("print-man") ||
        command_line.has("print-completion")) {
      if (command_line.has("help"))
        print_help(std::cout, command_line);
      else if (command_line.has("version"))
        std::cout << program_name << ' ' << POINT_SET_FLOW_VERSION << std::endl;
      else if (command_line.has("print-man"))
        print_manual_page(std::cout, command_line, command_line.text("print-man"));
      else
        print_completion(std::cout, command_line, command_line.text("print-completion"));
      return SUCCESS;
    }
    const Settings settings = command_line.settings();
#ifdef CGAL_LINKED_WITH_TBB
    std::optional<tbb::global_control> limit;
    if (settings.threads != 0)
      limit.emplace(tbb::global_control::max_allowed_parallelism, settings.threads);
#endif
    check(settings.smoothing);
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
