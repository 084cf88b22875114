// SPDX-License-Identifier: GPL-3.0-or-later
#include "Frame_search.h"

#include <cstring>

namespace balanced_flow_blocks {

namespace {

constexpr std::uint64_t sign = std::uint64_t(1) << 63;

/// An integer that has the order of the number
std::uint64_t key_of(double number)
{
  std::uint64_t bits;
  std::memcpy(&bits, &number, sizeof bits);
  return (bits & sign) != 0 ? ~bits : bits | sign;
}

double number_of(std::uint64_t key)
{
  const std::uint64_t bits = (key & sign) != 0 ? key & ~sign : ~key;
  double number;
  std::memcpy(&number, &bits, sizeof number);
  return number;
}

} // namespace

Frame_search::Frame_search()
{
  for (std::vector<std::uint64_t>& counts : m_counts)
    counts.assign(std::size_t(1) << 16, 0);
}

void Frame_search::add(const Records& records)
{
  const int shift = 48 - 16 * m_pass;
  for (std::size_t i = 0; i < records.size(); ++i)
    for (std::size_t d = 0; d < 3; ++d) {
      const std::uint64_t key = key_of(records.value(i, d));
      if (m_pass == 0 || key >> (shift + 16) == m_prefix[d])
        ++m_counts[d][key >> shift & 0xffff];
    }
  if (m_pass != 0)
    return;
  m_count += records.size();
  for (std::size_t i = 0; i < records.size(); ++i)
    m_box.add({records.value(i, 0), records.value(i, 1), records.value(i, 2)});
}

void Frame_search::end_pass()
{
  for (std::size_t d = 0; d < 3; ++d) {
    if (m_pass == 0)
      m_rank[d] = m_count / 2;
    std::uint64_t digit = 0;
    while (m_rank[d] >= m_counts[d][digit])
      m_rank[d] -= m_counts[d][digit++];
    m_prefix[d] = m_prefix[d] << 16 | digit;
    m_counts[d].assign(m_counts[d].size(), 0);
  }
  ++m_pass;
}

CGAL::Point_set_flow::Coordinate_frame Frame_search::frame() const
{
  const auto point = [](const std::array<double, 3>& p) {
    return CGAL::Point_set_flow::Point_3(p[0], p[1], p[2]);
  };
  return {point({number_of(m_prefix[0]), number_of(m_prefix[1]), number_of(m_prefix[2])}),
          point(m_box.low), point(m_box.high)};
}

} // namespace balanced_flow_blocks
