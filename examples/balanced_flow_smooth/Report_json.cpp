// SPDX-License-Identifier: GPL-3.0-or-later
#include "Report.h"
#include "command_line/Manual.h"

#include <nlohmann/json.hpp>

#include <fstream>
#include <iostream>
#include <stdexcept>

namespace balanced_flow_smooth {

namespace {

typedef nlohmann::ordered_json Json;

void add_file(Json& json, const File_report& r, const Settings& settings)
{
  json["input"] = r.job.input.string();
  if (!r.job.output.empty() && !settings.dry_run)
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
    json["scans"] = r.scans;
    json["normals"] = r.normals;
    json["unknown_normals"] = r.unknown_normals;
    for (const auto& [role, column] : r.roles)
      json["columns"][role] = column;
    if (!r.roles.empty())
      json["columns_source"] = r.roles_source;
  }
  if (r.movement) {
    json["mean_movement"] = r.movement->mean;
    json["moved"] = r.movement->number_of_points;
  }
}

Json parameters_to_json(const Smoothing_report& r, const Smoothing_settings& s)
{
  Json parameters;
  parameters["flow"] = s.flow;
  parameters["curvature"] = s.curvature;
  parameters["noise"] = nullptr; // estimated
  if (s.noise)
    parameters["noise"] = *s.noise;
  parameters["neighbors"] = {{"fewest", r.fewest_neighbors}, {"most", r.most_neighbors}};
  parameters["neighbor_radius"] = s.neighbor_radius;
  parameters["iterations"] = s.iterations;
  parameters["relaxation_steps"] = s.relaxation_steps;
  parameters["sharpness_angle"] = s.sharpness_angle;
  parameters["feature_threshold"] = r.feature_threshold;
  parameters["filter_width"] = r.filter_width;
  parameters["step_length"] = s.step_length;
  parameters["update_period"] = s.update_period;
  return parameters;
}

/// What holds for all files of a scene, or for the only one
void add_smoothing(Json& json, const Scene_report& scene, const Settings& settings)
{
  if (scene.sided_points)
    json["sided_points"] = *scene.sided_points;
  if (scene.smoothing) {
    const Smoothing_report& r = *scene.smoothing;
    json["spacing"] = r.spacing;
    json["noise"] = r.noise;
    json["parameters"] = parameters_to_json(r, settings.smoothing);
    if (!settings.dry_run) {
      json["mean_movement"] = r.mean_movement;
      json["last_movement"] = r.last_movement;
      json["moved"] = r.number_of_moved_points;
      json["not_moved"] = {{"without_noise", r.number_of_points_without_noise},
                           {"too_few_neighbors", r.number_of_isolated_points},
                           {"constrained", r.number_of_constrained_points},
                           {"at_rest", r.number_of_points_at_rest}};
    }
  }
  json["seconds"] = scene.seconds;
}

void print_json(std::ostream& out, const std::vector<Scene_report>& reports,
                const Settings& settings)
{
  Json json;
  json["program"] = program_name;
  json["version"] = POINT_SET_FLOW_VERSION;
  json["dry_run"] = settings.dry_run;
  json["files"] = Json::array();
  for (const Scene_report& scene : reports) {
    for (const File_report& file : scene.files) {
      add_file(json["files"].emplace_back(), file, settings);
      if (!settings.together)
        add_smoothing(json["files"].back(), scene, settings);
    }
    if (settings.together) {
      Json& together = json["together"];
      together["points"] = scene.sum(&File_report::points);
      together["scans"] = scene.sum(&File_report::scans);
      add_smoothing(together, scene, settings);
    }
  }
  // names of files may be any bytes
  out << json.dump(2, ' ', false, Json::error_handler_t::replace) << std::endl;
}

} // namespace

void write_json(const std::vector<Scene_report>& reports, const Settings& settings)
{
  if (settings.report == "-")
    return print_json(std::cout, reports, settings);
  std::ofstream out(settings.report);
  print_json(out, reports, settings);
  if (!out.flush())
    throw std::runtime_error("cannot write " + settings.report + ": writing failed");
}

} // namespace balanced_flow_smooth
