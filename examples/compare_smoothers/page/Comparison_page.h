// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef COMPARISON_COMPARISON_PAGE_H
#define COMPARISON_COMPARISON_PAGE_H

#include "measure/Result_table.h"
#include "measure/Surface.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace comparison {

/// A page that shows clouds side by side, with all that it needs in one file.
class Comparison_page {
  nlohmann::ordered_json m_data, m_clouds;
  std::size_t m_most;

public:
  /// \param most the number of points that are drawn of a cloud; of larger ones it is a sample
  explicit Comparison_page(std::size_t most) : m_most(most) {}

  /// What else the page says: "input", "radius" (of the data, in their unit), "noise" (rms), ...
  template <typename Value>
  void set(const std::string& name, const Value& value)
  {
    m_data[name] = value;
  }

  /// \param errors of the points; empty if they are not known
  /// \param shown whether the cloud is there when the page opens
  void add(const std::string& name, const std::string& title, const Points& points,
           const std::vector<double>& errors, bool shown);

  /// Throws `std::runtime_error` if there is no cloud, or the file can not be written.
  void write(const std::string& file, const Result_table& table) const;
};

} // namespace comparison

#endif // COMPARISON_COMPARISON_PAGE_H
