// SPDX-License-Identifier: GPL-3.0-or-later
#include "Splits.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace balanced_flow_blocks {

std::optional<std::pair<Split, std::size_t>> split_in_two(const Records& records,
                                                          std::uint32_t* first, std::uint32_t* last)
{
  Box box;
  for (const std::uint32_t* i = first; i != last; ++i)
    box.add({records.value(*i, 0), records.value(*i, 1), records.value(*i, 2)});
  Split split;
  const auto length = [&](std::size_t d) { return box.high[d] / 2. - box.low[d] / 2.; };
  for (std::size_t d = 1; d < 3; ++d)
    if (length(d) > length(split.axis))
      split.axis = d;
  if (!(box.high[split.axis] > box.low[split.axis]))
    return std::nullopt;
  const auto value = [&](std::uint32_t i) { return records.value(i, split.axis); };
  std::uint32_t* const middle = first + (last - first) / 2;
  std::nth_element(first, middle, last,
                   [&](std::uint32_t i, std::uint32_t j) { return value(i) < value(j); });
  split.value = value(*middle);
  if (split.value == box.low[split.axis]) { // none would be below
    split.value = (std::numeric_limits<double>::infinity)();
    for (const std::uint32_t* i = first; i != last; ++i)
      if (value(*i) > box.low[split.axis])
        split.value = (std::min)(split.value, value(*i));
  }
  const std::uint32_t* const begin_above =
      std::partition(first, last, [&](std::uint32_t i) { return split.is_below(records, i); });
  return std::make_pair(split, std::size_t(begin_above - first));
}

Splits::Splits(const Records& sample, std::size_t most)
{
  std::vector<std::uint32_t> order(sample.size());
  std::iota(order.begin(), order.end(), 0u);
  add(sample, order.data(), order.data() + order.size(), most);
}

std::size_t Splits::add(const Records& sample, std::uint32_t* first, std::uint32_t* last,
                        std::size_t most)
{
  const std::size_t node = m_nodes.size();
  m_nodes.emplace_back();
  const auto split =
      std::size_t(last - first) > most ? split_in_two(sample, first, last) : std::nullopt;
  if (!split) {
    m_nodes[node].part = m_count++;
    return node;
  }
  m_nodes[node].split = split->first;
  std::uint32_t* const middle = first + split->second;
  const std::size_t below = add(sample, first, middle, most),
                    above = add(sample, middle, last, most);
  m_nodes[node].below = below;
  m_nodes[node].above = above;
  return node;
}

std::size_t Splits::part_of(const Records& records, std::size_t i) const
{
  std::size_t node = 0;
  while (m_nodes[node].below != 0)
    node = m_nodes[node].split.is_below(records, i) ? m_nodes[node].below : m_nodes[node].above;
  return m_nodes[node].part;
}

} // namespace balanced_flow_blocks
