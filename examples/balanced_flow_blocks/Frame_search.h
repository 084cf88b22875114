// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_BLOCKS_FRAME_SEARCH_H
#define BALANCED_FLOW_BLOCKS_FRAME_SEARCH_H

#include "Page.h"

#include <CGAL/Point_set_flow/Coordinate_frame.h>

#include <array>
#include <cstdint>
#include <vector>

namespace balanced_flow_blocks {

/// Finds the median of each coordinate exactly, in four passes over the points: each pass counts the values of
/// 16 more bits of those numbers that begin as the median does.
class Frame_search {
  int m_pass = 0;
  std::uint64_t m_count = 0;
  std::array<std::uint64_t, 3> m_prefix =
      {};                                   // the bits of the median that are known, highest first
  std::array<std::uint64_t, 3> m_rank = {}; // of the median among the numbers with this prefix
  std::array<std::vector<std::uint64_t>, 3> m_counts;
  Box m_box;

public:
  static constexpr int number_of_passes = 4;

  Frame_search();

  void add(const Records& records);
  void end_pass();

  /// \pre all passes are done
  CGAL::Point_set_flow::Coordinate_frame frame() const;
};

} // namespace balanced_flow_blocks

#endif // BALANCED_FLOW_BLOCKS_FRAME_SEARCH_H
