// SPDX-License-Identifier: GPL-3.0-or-later
// Smooths the points of files and keeps everything else in them.
#include "Interrupt.h"
#include "Report.h"
#include "command_line/Command_line.h"
#include "command_line/Manual.h"
#include "command_line/print_completion.h"
#include "command_line/print_manual.h"
#include "memory_use.h"
#include "run.h"
#include "smooth.h"
#include "smooth_in_blocks.h"

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <iostream>
#include <new>
#include <optional>
#include <string>
#include <utility>
#include <vector>

using namespace balanced_flow_smooth;

namespace {

enum Exit_code { SUCCESS = 0, BAD_USAGE = 1, BAD_FILE = 2, SIGNALLED = 128 };

void complain(const std::string& what) { std::cerr << program_name << ": " << what << std::endl; }

/// The jobs that are smoothed as one: each alone, or all
std::vector<Scene_report> scenes_of(const Settings& settings)
{
  std::vector<Scene_report> scenes;
  for (const Job& job : settings.jobs) {
    if (scenes.empty() || !settings.together)
      scenes.emplace_back();
    scenes.back().files.emplace_back().job = job;
  }
  return scenes;
}

/// Tells why the files of a scene are not written.
void set_status(Scene_report& scene, const char* status, const std::string& message = "")
{
  for (File_report& file : scene.files) {
    file.status = status;
    file.message = message;
    file.movement.reset();
  }
}

std::string message_of(const std::exception& e, const Scene_report& scene)
{
  std::string message = e.what();
  if (dynamic_cast<const std::bad_alloc*>(&e))
    message = scene.files.front().job.input.string() +
              (scene.files.size() > 1 ? " and the others" : "") + ": not enough memory";
  return message + (scene.files.size() > 1 ? " (so none of the files is written)" : "");
}

/// Smooths all files, as far as it goes.
int run_all(const Settings& settings)
{
  int code = SUCCESS;
  std::vector<Scene_report> reports;
  for (Scene_report& scene : scenes_of(settings)) {
    Scene_report& report = reports.emplace_back(std::move(scene));
    try {
      if (!run(settings, report)) {
        set_status(report, "interrupted");
        std::cerr << "\ninterrupted, nothing written" << std::endl;
        code = SIGNALLED + interrupt;
        break;
      }
      if (!settings.quiet && settings.report != "-")
        print_summary(settings.points_to_standard_output() ? std::cerr : std::cout, report,
                      settings);
    }
    catch (const std::exception& e) {
      set_status(report, "failed", message_of(e, report));
      complain(report.files.front().message);
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
