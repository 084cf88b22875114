// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_BLOCKS_SETTINGS_TO_JSON_H
#define BALANCED_FLOW_BLOCKS_SETTINGS_TO_JSON_H

#include "command_line/Settings.h"

#include <nlohmann/json_fwd.hpp>

namespace balanced_flow_blocks {

/// What decides the result: all that the command line says of smoothing and of reading
nlohmann::ordered_json settings_to_json(const balanced_flow_smooth::Settings& settings);
balanced_flow_smooth::Settings settings_from_json(const nlohmann::ordered_json& json);

} // namespace balanced_flow_blocks

#endif // BALANCED_FLOW_BLOCKS_SETTINGS_TO_JSON_H
