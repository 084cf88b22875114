// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_BLOCKS_BLOCK_RESULT_H
#define BALANCED_FLOW_BLOCKS_BLOCK_RESULT_H

#include "Manifest.h"
#include "smooth.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

namespace balanced_flow_blocks {

using balanced_flow_smooth::Smoothing_report;

/// What is found and done in several blocks: counts are sums, lengths are means, weighted by the number of points
class Report_sum {
  Smoothing_report m_sum; // lengths and K times the number of points

public:
  void add(const Smoothing_report& report);
  Smoothing_report report() const;
};

nlohmann::ordered_json to_json(const Smoothing_report& report);

/// What it took to smooth a block
struct Effort {
  std::size_t points_at_hand = 0; // at most
  int trials = 0;                 // until the halo was large enough
  double halo_width = 0.;         // see `Experience`
};

/// The smoothed points of a block, in a file that begins with a line of JSON
class Block_result {
  std::filesystem::path m_path;
  std::uint64_t m_begin = 0, m_count = 0, m_checksum = 0, m_number_of_points;
  bool m_has_normals = false;
  Smoothing_report m_report;
  Effort m_effort;

public:
  /// Writes a result beside its place and renames it.
  static void write(const Manifest& manifest, std::size_t block, const Records& points,
                    const Smoothing_report& report, const Effort& effort);

  /// Whether there is a result of this block for the manifest.
  static bool exists(const Manifest& manifest, std::size_t block);

  /// Throws `std::runtime_error` if there is none, or if it is of another plan.
  Block_result(const Manifest& manifest, std::size_t block);

  const Smoothing_report& report() const { return m_report; }
  const Effort& effort() const { return m_effort; }

  /// Visits all points, with numbers that are there; throws `std::runtime_error`, at the latest at the end, if they are
  /// damaged.
  void for_each(const std::function<void(const Records&)>& visit) const;
};

} // namespace balanced_flow_blocks

#endif // BALANCED_FLOW_BLOCKS_BLOCK_RESULT_H
