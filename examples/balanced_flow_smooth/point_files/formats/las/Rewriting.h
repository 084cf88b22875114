// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_FILES_LAS_REWRITING_H
#define POINT_FILES_LAS_REWRITING_H

#include "../../Point_file.h"
#include "Header.h"
#include "Input.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

namespace point_files::las {

/// A file that is written once more with other coordinates. It stays on the disk, and its records are read
/// again.
class Rewriting {
  const Input& m_input;
  const Header& m_header;

public:
  /// what tells where points are now: asked for each point in ascending order, and once more from the first on
  std::function<Point_3(std::size_t)> point;
  /// which points are not written; empty if all are
  std::function<bool(std::size_t)> is_dropped;
  std::size_t number_of_dropped = 0;

  Rewriting(const Input& input, const Header& header) : m_input(input), m_header(header) {}

  void write(const Target& target) const;

private:
  /// What is different in the records from what they were
  struct Change {
    bool any = false;
    std::array<double, 3> min, max; // of all points that are written
    std::array<std::uint64_t, 15> dropped_returns;
  };

  std::array<std::int32_t, 3> new_integers(const char* record, std::size_t i) const;
  Change find_change() const;
  void announce(const Change& change, std::string& header) const;
};

} // namespace point_files::las

#endif // POINT_FILES_LAS_REWRITING_H
