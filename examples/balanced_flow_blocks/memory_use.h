// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_BLOCKS_MEMORY_USE_H
#define BALANCED_FLOW_BLOCKS_MEMORY_USE_H

#include "Page.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>

namespace balanced_flow_blocks {

// How many points fit into how much memory, in bytes. What a point at hand takes when a block is smoothed was measured
// with 32 and 128 neighbors.

constexpr std::uint64_t smallest_memory = std::uint64_t(256) << 20;
constexpr std::uint64_t memory_of_program = std::uint64_t(64) << 20;

/// "512M" or "2G" in bytes, and 2 GB if the text is empty. Throws `balanced_flow_smooth::Usage_error` if it is no size, or
/// too small.
std::uint64_t memory_from_text(const std::string& text);

/// Points at hand when a block is smoothed
inline std::size_t points_at_hand(std::uint64_t memory, std::size_t neighbors, bool has_normals)
{
  const std::size_t bytes = 220 + 6 * neighbors + (has_normals ? 100 : 0);
  return std::size_t((memory - memory_of_program) / bytes);
}

/// Points of a block; nearly as many again are the halo. It is smoothed in parts if there is so much noise that
/// more neighbors are needed.
inline std::size_t points_of_block(std::uint64_t memory)
{
  const std::size_t usual_neighbors = 40;
  return (std::min)(points_at_hand(memory, usual_neighbors, false) / 2, std::size_t(1) << 30);
}

/// Points that are sorted at a time
inline std::size_t points_to_sort(std::uint64_t memory, bool has_normals)
{
  return std::size_t((memory - memory_of_program) / 2 / (Records::bytes_of(has_normals) + 4));
}

/// Results that are put back into the order of the input at a time
inline std::size_t points_to_put_back(std::uint64_t memory, bool has_normals)
{
  return points_to_sort(memory, has_normals);
}

} // namespace balanced_flow_blocks

#endif // BALANCED_FLOW_BLOCKS_MEMORY_USE_H
