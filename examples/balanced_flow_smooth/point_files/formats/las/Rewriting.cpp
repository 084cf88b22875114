// SPDX-License-Identifier: GPL-3.0-or-later
#include "Rewriting.h"

#include "Bytes.h"
#include "Output.h"
#include "Records.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace point_files::las {

/// The coordinates of a point for its record; a coordinate that is the same stays the same.
std::array<std::int32_t, 3> Rewriting::new_integers(const char* record, std::size_t i) const
{
  const Point_3 p = point(i);
  std::array<std::int32_t, 3> integers;
  for (std::size_t c = 0; c < 3; ++c) {
    integers[c] = get<std::int32_t>(record + 4 * c);
    if (p[int(c)] != m_header.grid.coordinate(integers[c], c))
      integers[c] = m_header.grid.integer(p[int(c)], c, i);
  }
  return integers;
}

/// Finds out, before anything is written, whether all points can be written.
Rewriting::Change Rewriting::find_change() const
{
  std::array<std::int32_t, 3> min, max;
  min.fill((std::numeric_limits<std::int32_t>::max)());
  max.fill((std::numeric_limits<std::int32_t>::min)());
  Change change = {};
  const auto reader = make_reader(m_input, m_header);
  for (std::size_t i = 0; i < m_header.count; ++i) {
    const char* const record = reader->next();
    if (is_dropped && is_dropped(i)) {
      const unsigned bits = m_header.point_format < 6 ? 7 : 15;
      const unsigned number = get<std::uint8_t>(record + 14) & bits; // of the return, from 1 on
      if (number != 0)
        ++change.dropped_returns[number - 1];
      change.any = true;
      continue;
    }
    const auto integers = new_integers(record, i);
    for (std::size_t c = 0; c < 3; ++c) {
      change.any = change.any || integers[c] != get<std::int32_t>(record + 4 * c);
      min[c] = (std::min)(min[c], integers[c]);
      max[c] = (std::max)(max[c], integers[c]);
    }
  }
  for (std::size_t c = 0; c < 3; ++c)
    std::tie(change.min[c], change.max[c]) =
        std::minmax({m_header.grid.coordinate(min[c], c), m_header.grid.coordinate(max[c], c)});
  return change;
}

/// Sets the bounds, and the counts if points are dropped.
void Rewriting::announce(const Change& change, std::string& header) const
{
  for (std::size_t c = 0; c < 3; ++c) {
    put(&header[at::bounds + 16 * c], change.max[c]);
    put(&header[at::bounds + 16 * c + 8], change.min[c]);
  }
  if (number_of_dropped == 0)
    return;
  const auto subtract = [&](auto number, std::size_t place, std::uint64_t dropped) {
    typedef decltype(number) Count;
    const auto before = get<Count>(&header[place]); // 0 if the header does not tell it
    put(&header[place], Count(before - (std::min)(std::uint64_t(before), dropped)));
  };
  subtract(std::uint32_t(), at::legacy_count, number_of_dropped);
  for (std::size_t r = 0; r < 5; ++r)
    subtract(std::uint32_t(), at::legacy_counts_by_return + 4 * r, change.dropped_returns[r]);
  if (m_header.minor_version < 4)
    return;
  subtract(std::uint64_t(), at::count, number_of_dropped);
  for (std::size_t r = 0; r < 15; ++r)
    subtract(std::uint64_t(), at::counts_by_return + 8 * r, change.dropped_returns[r]);
}

void Rewriting::write(const Target& target) const
{
  m_input.check_unchanged();
  const Change change = find_change();
  const bool is_laz = target.format.name == "laz";
  if (!change.any && is_laz == m_header.is_compressed)
    m_input.copy(0, m_input.size(), target.out);
  else {
    Frame frame(m_input, m_header, is_laz || m_header.is_compressed);
    frame.count = m_header.count - number_of_dropped;
    if (change.any)
      announce(change, frame.header);
    write_file(target, frame, [&](Record_writer& writer) {
      const auto reader = make_reader(m_input, m_header);
      for (std::size_t i = 0; i < m_header.count; ++i) {
        char* const record = reader->next();
        if (is_dropped && is_dropped(i))
          continue;
        const auto integers = new_integers(record, i);
        for (std::size_t c = 0; c < 3; ++c)
          put(record + 4 * c, integers[c]);
        writer.write(record);
      }
    });
  }
  m_input.check_unchanged();
}

} // namespace point_files::las
