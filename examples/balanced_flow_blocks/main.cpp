// SPDX-License-Identifier: GPL-3.0-or-later
// Smooths point sets that do not fit into memory, on one machine or many.
#include "Block_result.h"
#include "Interrupt.h"
#include "Manifest.h"
#include "Manual.h"
#include "Progress_bar.h"
#include "command_line/Command_line.h"
#include "command_line/print_completion.h"
#include "command_line/print_manual.h"
#include "join.h"
#include "plan.h"
#include "run.h"
#include "smooth_one.h"

#include <nlohmann/json.hpp>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

using namespace balanced_flow_blocks;
using balanced_flow_smooth::Command_line;
using balanced_flow_smooth::Usage_error;

namespace {

enum Exit_code { SUCCESS = 0, BAD_USAGE = 1, BAD_FILE = 2, SIGNALLED = 128 };

/// What is asked for
struct Request {
  std::string command;
  std::filesystem::path directory;
  std::vector<std::string> words; // the others
  Settings settings;
};

Request read_request(Command_line& command_line)
{
  Request request;
  request.settings = command_line.settings_without_jobs();
  request.words = command_line.words();
  if (request.words.size() < 2)
    throw Usage_error("a command and a directory are required");
  request.command = request.words[0];
  request.directory = request.words[1];
  request.words.erase(request.words.begin(), request.words.begin() + 2);
  for (const char* option : {"in-place", "normals", "dry-run"})
    if (command_line.has(option) && !command_line.is_default(option))
      throw Usage_error("--" + std::string(option) + " is an option of balanced-flow-smooth");
  if (command_line.has("output-format"))
    throw Usage_error("files keep their format");
  if (request.settings.invalid == point_files::Invalid::DROP)
    throw Usage_error("invalid points can be kept only");
  return request;
}

std::size_t block_number(const std::string& word)
{
  if (word.empty() || word.size() > 9 || word.find_first_not_of("0123456789") != std::string::npos)
    throw Usage_error("\"" + word + "\" is no number of a block");
  return std::stoul(word);
}

void expect_words(const Request& request, std::size_t count)
{
  if (request.words.size() != count)
    throw Usage_error("the command " + request.command + " takes a directory" +
                      (count == 0 ? "" : " and the number of a block"));
}

nlohmann::ordered_json describe(const Manifest& manifest)
{
  nlohmann::ordered_json json;
  json["program"] = program_name;
  json["version"] = POINT_SET_FLOW_VERSION;
  json["directory"] = manifest.directory.string();
  json["points"] = manifest.number_of_points;
  json["inputs"] = manifest.inputs.size();
  json["blocks"] = manifest.blocks.size();
  json["smoothed_blocks"] = number_of_results(manifest);
  return json;
}

/// Says what there is now, for people or as JSON.
void tell(const Manifest& manifest, const Settings& settings,
          const std::optional<Smoothing_report>& report)
{
  nlohmann::ordered_json json = describe(manifest);
  if (report)
    json["smoothing"] = to_json(*report);
  if (settings.report == "-")
    std::cout << json.dump(2) << std::endl;
  else if (!settings.report.empty()) {
    std::ofstream out(settings.report);
    if (!(out << json.dump(2) << std::endl))
      throw std::runtime_error("cannot write " + settings.report);
  }
  if (settings.report == "-" || settings.quiet)
    return;
  std::cout << "points            " << manifest.number_of_points << "\n"
            << "inputs            " << manifest.inputs.size() << "\n"
            << "blocks            " << manifest.blocks.size() << ", " << json["smoothed_blocks"]
            << " of them smoothed\n";
  if (report)
    std::cout << "noise             " << report->noise << "\n"
              << "spacing           " << report->spacing << "\n"
              << "moved             " << report->number_of_moved_points << "\n"
              << "mean movement     " << report->mean_movement << "\n";
  std::cout << std::flush;
}

Manifest plan_request(const Request& request, const std::filesystem::path& output_directory,
                      const Progress& progress)
{
  std::vector<std::pair<std::filesystem::path, std::filesystem::path>> files;
  for (const std::filesystem::path& file : files_of({request.words.begin(), request.words.end()}))
    files.emplace_back(file, output_directory.empty() ? std::filesystem::path()
                                                      : output_directory / file.filename());
  return plan(request_of(request.settings, request.directory, files), progress);
}

void run_command(const Request& request, const std::filesystem::path& output_directory)
{
  balanced_flow_smooth::Progress_bar bar(!request.settings.quiet && isatty(STDERR_FILENO));
  const Progress progress(std::ref(bar));
  const bool plans =
      request.command == "plan" || (request.command == "run" && !request.words.empty());
  if (request.command == "plan" && request.words.empty())
    throw Usage_error("the command plan takes a directory and inputs");
  if (!plans)
    expect_words(request, request.command == "smooth" ? 1 : 0);
  const Manifest manifest = plans ? plan_request(request, output_directory, progress.part(0., .1))
                                  : Manifest::read(request.directory);
  std::optional<Smoothing_report> report;
  if (request.command == "smooth")
    smooth_one(manifest, block_number(request.words[0]), progress);
  else if (request.command == "join")
    report = join(manifest, progress);
  else if (request.command == "run") {
    smooth_all(manifest, request.settings.processes, progress.part(.1, .95));
    report = join(manifest, progress.part(.95, 1.));
  }
  else if (request.command != "plan" && request.command != "status")
    throw Usage_error("there is no command \"" + request.command +
                      "\", only plan, smooth, join, run and status");
  if (request.command != "status")
    progress(1.);
  if (request.command != "smooth" || !request.settings.report.empty())
    tell(manifest, request.settings, report);
}

/// Prints what was asked for in place of smoothing.
/// \return whether anything was
bool print_information(const Command_line& command_line)
{
  if (command_line.has("help"))
    print_help(std::cout, manual_page(), command_line);
  else if (command_line.has("version"))
    std::cout << program_name << ' ' << POINT_SET_FLOW_VERSION << std::endl;
  else if (command_line.has("print-man"))
    print_manual_page(std::cout, manual_page(), command_line, command_line.text("print-man"));
  else if (command_line.has("print-completion"))
    print_completion(std::cout, command_line, {program_name, commands},
                     command_line.text("print-completion"));
  else
    return false;
  return true;
}

void complain(const std::string& what) { std::cerr << program_name << ": " << what << std::endl; }

} // namespace

int main(int argc, char** argv)
{
  std::ios::sync_with_stdio(false);
  balanced_flow_smooth::listen_for_interrupts();
  try {
    Command_line command_line;
    command_line.read(argc, argv);
    if (print_information(command_line))
      return SUCCESS;
    const std::string output_directory =
        command_line.has("output-dir") ? command_line.text("output-dir") : "";
    const Request request = read_request(command_line);
    check(request.settings.smoothing);
#ifdef CGAL_LINKED_WITH_TBB
    std::optional<tbb::global_control> limit;
    unsigned int threads = request.settings.threads;
    if (threads == 0 && request.settings.processes > 1)
      threads = (std::max)(std::thread::hardware_concurrency() / request.settings.processes, 1u);
    if (threads != 0)
      limit.emplace(tbb::global_control::max_allowed_parallelism, threads);
#endif
    run_command(request, output_directory);
    return SUCCESS;
  }
  catch (const Interrupted&) {
    std::cerr << "\ninterrupted; the same command goes on" << std::endl;
    return SIGNALLED + balanced_flow_smooth::interrupt;
  }
  catch (const Usage_error& e) {
    complain(e.what() + std::string(" (see --help)"));
    return BAD_USAGE;
  }
  catch (const std::invalid_argument& e) { // a value that the library refuses
    complain(e.what());
    return BAD_USAGE;
  }
  catch (const std::bad_alloc&) {
    complain("not enough memory");
    return BAD_FILE;
  }
  catch (const std::exception& e) {
    complain(e.what());
    return BAD_FILE;
  }
}
