// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_BLOCKS_SPLITS_H
#define BALANCED_FLOW_BLOCKS_SPLITS_H

#include "Page.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace balanced_flow_blocks {

/// Where points are split in two
struct Split {
  std::size_t axis = 0;
  double value = 0.;

  bool is_below(const Records& records, std::size_t i) const
  {
    return records.value(i, axis) < value;
  }
};

/// Splits points at the median of the longest side of their box, and puts those below it first.
/// \return the split, and how many are below; nothing if all are in one place
std::optional<std::pair<Split, std::size_t>>
split_in_two(const Records& records, std::uint32_t* first, std::uint32_t* last);

/// Distributes points to parts of about the same number, by splits that a sample of the points tells.
class Splits {
  struct Node {
    Split split;
    std::size_t below = 0, above = 0; // nodes, or 0 if this is a part
    std::size_t part = 0;
  };
  std::vector<Node> m_nodes;
  std::size_t m_count = 0;

public:
  /// \param most the largest number of sample points in a part
  Splits(const Records& sample, std::size_t most);

  std::size_t number_of_parts() const { return m_count; }
  std::size_t part_of(const Records& records, std::size_t i) const;

private:
  std::size_t add(const Records& sample, std::uint32_t* first, std::uint32_t* last,
                  std::size_t most);
};

} // namespace balanced_flow_blocks

#endif // BALANCED_FLOW_BLOCKS_SPLITS_H
