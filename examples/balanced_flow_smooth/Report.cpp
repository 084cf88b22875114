// SPDX-License-Identifier: GPL-3.0-or-later
#include "Report.h"

#include "command_line/Manual.h"

#include <nlohmann/json.hpp>

#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>

namespace balanced_flow_smooth {

namespace {

std::string neighbors_to_text(const Smoothing_report& r)
{
  const std::string most = std::to_string(r.most_neighbors);
  return r.fewest_neighbors == r.most_neighbors
             ? most
             : std::to_string(r.fewest_neighbors) + " to " + most;
}

/// "84.1%"; neither none nor all if it is not exactly that
std::string share_to_text(std::size_t count, std::size_t of)
{
  if (count != 0 && double(count) < .001 * double(of))
    return "less than 0.1%";
  if (count != of && double(count) > .999 * double(of))
    return "more than 99.9%";
  std::ostringstream text;
  text.precision(3);
  text << 100. * double(count) / double(of) << '%';
  return text.str();
}

/// How many points moved, and why the others did not
std::string movement_to_text(const Smoothing_report& r, bool makes_steps)
{
  const std::size_t all = r.number_of_points;
  std::string text = share_to_text(r.number_of_moved_points, all) + " of the points";
  const char* between = "; ";
  const auto add = [&](std::size_t count, const char* what) {
    if (count != 0)
      text += between + share_to_text(count, all) + what, between = ", ";
  };
  add(r.number_of_points_without_noise, " have no noise");
  add(r.number_of_isolated_points, " have fewer than two neighbors or are far from all others");
  add(r.number_of_constrained_points, " are constrained");
  add(r.number_of_points_at_rest, makes_steps ? " lie on their surface already" : " made no step");
  return text;
}

/// What the user can do if nothing moved; empty if there is nothing to do.
std::string advice(const Smoothing_report& r, const Smoothing_settings& s)
{
  if (r.number_of_moved_points != 0 || !s.makes_steps())
    return "";
  if (r.number_of_points_without_noise != 0)
    return "no noise was found; --noise sets its standard deviation by hand";
  if (r.number_of_isolated_points != 0 && s.neighbor_radius > 0.)
    return "a larger --neighbor-radius finds more neighbors";
  return "";
}

/// What was taken for coordinates and normals
std::string roles_to_text(const File_report& r)
{
  std::string text;
  for (const auto& [role, column] : r.roles)
    text += (text.empty() ? "" : ", ") + role + " " + std::to_string(column);
  text += ", by " + r.roles_source;
  if (r.unknown_normals != 0)
    text += "; " + std::to_string(r.unknown_normals) + " normals are null or not finite";
  return text;
}

nlohmann::ordered_json to_json(const File_report& r, const Settings& settings)
{
  const Smoothing_settings& s = settings.smoothing;
  nlohmann::ordered_json json;
  json["input"] = r.job.input.string();
  if (!settings.dry_run)
    json["output"] = r.job.output.string();
  json["status"] = r.status;
  if (!r.message.empty())
    json["message"] = r.message;
  if (!r.warnings.empty())
    json["warnings"] = r.warnings;
  if (!r.format.empty())
    json["format"] = r.format;
  if (!r.output_format.empty())
    json["output_format"] = r.output_format;
  if (r.points != 0) {
    json["points"] = r.points;
    json["invalid_points"] = r.invalid_points;
    json["normals"] = r.normals;
    json["unknown_normals"] = r.unknown_normals;
    for (const auto& [role, column] : r.roles)
      json["columns"][role] = column;
    if (!r.roles.empty())
      json["columns_source"] = r.roles_source;
  }
  if (r.smoothing) {
    json["spacing"] = r.smoothing->spacing;
    json["noise"] = r.smoothing->noise;
    nlohmann::ordered_json& parameters = json["parameters"];
    parameters["flow"] = s.flow;
    parameters["curvature"] = s.curvature;
    parameters["noise"] = nullptr; // estimated
    if (s.noise)
      parameters["noise"] = *s.noise;
    parameters["neighbors"] = {{"fewest", r.smoothing->fewest_neighbors},
                               {"most", r.smoothing->most_neighbors}};
    parameters["neighbor_radius"] = s.neighbor_radius;
    parameters["iterations"] = s.iterations;
    parameters["sharpness_angle"] = s.sharpness_angle;
    parameters["feature_threshold"] = r.smoothing->feature_threshold;
    parameters["filter_width"] = r.smoothing->filter_width;
    parameters["step_length"] = s.step_length;
    parameters["update_period"] = s.update_period;
  }
  if (r.smoothing && !settings.dry_run) {
    json["mean_movement"] = r.smoothing->mean_movement;
    json["last_movement"] = r.smoothing->last_movement;
    json["moved"] = r.smoothing->number_of_moved_points;
    json["not_moved"] = {{"without_noise", r.smoothing->number_of_points_without_noise},
                         {"too_few_neighbors", r.smoothing->number_of_isolated_points},
                         {"constrained", r.smoothing->number_of_constrained_points},
                         {"at_rest", r.smoothing->number_of_points_at_rest}};
  }
  json["seconds"] = r.seconds;
  return json;
}

void print_json(std::ostream& out, const std::vector<File_report>& reports,
                const Settings& settings)
{
  nlohmann::ordered_json json;
  json["program"] = program_name;
  json["version"] = POINT_SET_FLOW_VERSION;
  json["dry_run"] = settings.dry_run;
  json["files"] = nlohmann::ordered_json::array();
  for (const File_report& report : reports)
    json["files"].push_back(to_json(report, settings));
  // names of files may be any bytes
  out << json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << std::endl;
}

} // namespace

void print_summary(std::ostream& out, const File_report& r, const Settings& settings)
{
  const Smoothing_settings& s = settings.smoothing;
  const bool is_dry_run = settings.dry_run;
  if (settings.jobs.size() > 1)
    out << r.job.input.string() << "\n";
  out << "points            " << r.points << "\n";
  if (r.invalid_points != 0)
    out << "invalid points    " << r.invalid_points
        << (r.drops_invalid ? ", dropped" : ", kept as they are") << "\n";
  if (!r.roles.empty())
    out << "columns           " << roles_to_text(r) << "\n";
  out << "spacing           " << r.smoothing->spacing << "\n"
      << (s.noise ? "given noise       " : "estimated noise   ") << r.smoothing->noise << "\n"
      << "neighbors         " << neighbors_to_text(*r.smoothing)
      << (s.k || s.is_paper_estimator() ? "" : " (fewer where two sheets are close)") << "\n"
      << "iterations        " << s.iterations << "\n";
  if (!is_dry_run) {
    out << "moved             " << movement_to_text(*r.smoothing, s.makes_steps()) << "\n";
    const std::string hint = advice(*r.smoothing, s);
    if (!hint.empty())
      out << "hint              " << hint << "\n";
    out << "mean movement     " << r.smoothing->mean_movement
        << " (last iteration: " << r.smoothing->last_movement << ")\n";
  }
  else
    out << "flow              " << s.flow << ", with the estimator " << s.curvature << "\n"
        << "step length       " << s.step_length << "\n"
        << "update period     " << s.update_period << "\n"
        << "filter width      " << r.smoothing->filter_width << "\n"
        << "feature threshold " << r.smoothing->feature_threshold << "\n";
  out << "seconds           " << r.seconds << std::endl;
}

void write_json(const std::vector<File_report>& reports, const Settings& settings)
{
  if (settings.report == "-")
    return print_json(std::cout, reports, settings);
  std::ofstream out(settings.report);
  print_json(out, reports, settings);
  if (!out.flush())
    throw std::runtime_error("cannot write " + settings.report + ": writing failed");
}

} // namespace balanced_flow_smooth
