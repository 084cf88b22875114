// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_BLOCKS_PLAN_H
#define BALANCED_FLOW_BLOCKS_PLAN_H

#include "Manifest.h"
#include "Progress.h"

#include <cstdint>
#include <filesystem>
#include <utility>
#include <vector>

namespace balanced_flow_blocks {

/// What `plan` is asked for
struct Plan_request {
  std::filesystem::path directory;
  /// each input, and where it is written; the output is empty for the default, in the directory
  std::vector<std::pair<std::filesystem::path, std::filesystem::path>> files;
  Settings settings;
  std::uint64_t memory = 0;
  std::uint64_t block_size = 0;    // 0: as memory allows
  bool may_replace_inputs = false; // then `join` can be done once only
};

/// \param files see `Plan_request::files`
/// \throws balanced_flow_smooth::Usage_error if the memory of the settings is no size, or too small
Plan_request request_of(const Settings& settings, const std::filesystem::path& directory,
                        std::vector<std::pair<std::filesystem::path, std::filesystem::path>> files);

/// The files of inputs, some of which may be directories: their files of known formats, in the order of their names
std::vector<std::filesystem::path> files_of(const std::vector<std::filesystem::path>& inputs);

/// Sorts the points of all files into blocks. If the directory is planned in the same way already, nothing is done; if
/// it is planned in another way, throws `std::runtime_error`.
Manifest plan(const Plan_request& request, const Progress& progress);

} // namespace balanced_flow_blocks

#endif // BALANCED_FLOW_BLOCKS_PLAN_H
