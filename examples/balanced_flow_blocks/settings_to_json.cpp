// SPDX-License-Identifier: GPL-3.0-or-later
#include "settings_to_json.h"

#include <nlohmann/json.hpp>

#include <optional>

namespace balanced_flow_blocks {

namespace {

typedef nlohmann::ordered_json Json;

/// Visits what both directions have in common: a new setting is entered once, here.
template <typename Settings, typename Visit>
void for_each_setting(Settings& settings, const Visit& visit)
{
  auto& s = settings.smoothing;
  visit("flow", s.flow);
  visit("curvature", s.curvature);
  visit("neighbors", s.k);
  visit("iterations", s.iterations);
  visit("relaxation_steps", s.relaxation_steps);
  visit("update_period", s.update_period);
  visit("neighbor_radius", s.neighbor_radius);
  visit("sharpness_angle", s.sharpness_angle);
  visit("step_length", s.step_length);
  visit("noise", s.noise);
  visit("fills_normals", s.fills_normals);
  visit("feature_threshold", s.feature_threshold);
  visit("filter_width", s.filter_width);
  visit("columns", settings.columns);
  visit("invalid", settings.invalid);
  visit("zeros_are_invalid", settings.zeros_are_invalid);
  visit("together", settings.together);
}

/// To JSON
struct Setting_writer {
  Json& json;

  template <typename T>
  void operator()(const char* name, const T& value) const
  {
    json[name] = value;
  }
  template <typename T>
  void operator()(const char* name, const std::optional<T>& value) const
  {
    json[name] = value ? Json(*value) : Json();
  }
};

/// From JSON
struct Setting_reader {
  const Json& json;

  template <typename T>
  void operator()(const char* name, T& value) const
  {
    value = json.at(name).get<T>();
  }
  template <typename T>
  void operator()(const char* name, std::optional<T>& value) const
  {
    if (!json.at(name).is_null())
      value = json.at(name).get<T>();
  }
};

} // namespace

Json settings_to_json(const balanced_flow_smooth::Settings& settings)
{
  Json json;
  for_each_setting(settings, Setting_writer{json});
  json["format"] = settings.input_format ? settings.input_format->name : "";
  return json;
}

balanced_flow_smooth::Settings settings_from_json(const Json& json)
{
  balanced_flow_smooth::Settings settings;
  for_each_setting(settings, Setting_reader{json});
  settings.input_format = point_files::find_format(json.at("format").get<std::string>());
  return settings;
}

} // namespace balanced_flow_blocks
