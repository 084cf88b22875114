// SPDX-License-Identifier: GPL-3.0-or-later
#include "Page.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace balanced_flow_blocks {

Box::Box()
{
  low.fill((std::numeric_limits<double>::infinity)());
  high.fill(-(std::numeric_limits<double>::infinity)());
}

void Box::add(const std::array<double, 3>& p)
{
  for (std::size_t d = 0; d < 3; ++d) {
    low[d] = (std::min)(low[d], p[d]);
    high[d] = (std::max)(high[d], p[d]);
  }
}

void Box::add(const Box& box)
{
  add(box.low);
  add(box.high);
}

double Box::distance(const std::array<double, 3>& p) const
{
  const auto beyond = [&](std::size_t d) {
    return (std::max)({low[d] - p[d], p[d] - high[d], 0.});
  };
  const double x = beyond(0), y = beyond(1), z = beyond(2), squared = x * x + y * y + z * z;
  const double rounding = 1e-14;
  const bool is_in_range = squared > 1e-280 && squared < 1e280;
  return (is_in_range ? std::sqrt(squared) : std::hypot(x, y, z)) * (1. - rounding);
}

double Box::distance(const Box& box) const
{
  const auto beyond = [&](std::size_t d) {
    return (std::max)({low[d] - box.high[d], box.low[d] - high[d], 0.});
  };
  return std::hypot(beyond(0), beyond(1), beyond(2));
}

double Page::spacing() const
{
  const double x = box.high[0] - box.low[0], y = box.high[1] - box.low[1],
               z = box.high[2] - box.low[2];
  return std::sqrt(std::hypot(x * y, y * z, z * x) / double(count));
}

void Checksum::add(const char* bytes, std::size_t count)
{
  // FNV-1a of words: of single bytes it would take longer than reading them
  const auto step = [&](std::uint64_t word) {
    m_value = (m_value ^ word) * 0x100000001b3;
    m_value ^= m_value >> 32;
  };
  std::size_t i = 0;
  for (; i + sizeof(std::uint64_t) <= count; i += sizeof(std::uint64_t)) {
    std::uint64_t word;
    std::memcpy(&word, bytes + i, sizeof word);
    step(word);
  }
  for (; i < count; ++i)
    step(static_cast<unsigned char>(bytes[i]));
}

} // namespace balanced_flow_blocks
