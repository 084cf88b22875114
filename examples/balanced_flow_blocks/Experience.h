// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_BLOCKS_EXPERIENCE_H
#define BALANCED_FLOW_BLOCKS_EXPERIENCE_H

#include "Manifest.h"

#include <cstddef>

namespace balanced_flow_blocks {

/// What a block is expected to take: as the one before. No result depends on it, only time and memory.
struct Experience {
  double halo_width = 120.;         ///< in spacings
  std::size_t most_neighbors = 128; ///< of a point; the default is the most that noise leads to

  /// What the results of the blocks before this one tell, which are near it; the default if there are none.
  static Experience before(const Manifest& manifest, std::size_t block);

  /// Learns that a halo was too narrow.
  void widen();
  /// Learns how many neighbors there were.
  void set_neighbors(std::size_t number);
};

} // namespace balanced_flow_blocks

#endif // BALANCED_FLOW_BLOCKS_EXPERIENCE_H
