// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_BLOCKS_WRITTEN_OUTPUTS_H
#define BALANCED_FLOW_BLOCKS_WRITTEN_OUTPUTS_H

#include "Manifest.h"

#include <cstddef>
#include <filesystem>
#include <map>

namespace balanced_flow_blocks {

/// Which outputs are complete: a list in the working directory, with the size and the time of each
class Written_outputs {
  const Manifest& m_manifest;
  const std::filesystem::path m_path;
  std::map<std::size_t, Input_file> m_written; // as they were then

public:
  explicit Written_outputs(const Manifest& manifest);

  /// Whether an output is there, and nobody has changed it since it was written.
  bool has(std::size_t input) const;
  /// Notes that an output was written.
  void add(std::size_t input);
};

} // namespace balanced_flow_blocks

#endif // BALANCED_FLOW_BLOCKS_WRITTEN_OUTPUTS_H
