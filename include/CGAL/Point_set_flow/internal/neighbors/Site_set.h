// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_SITE_SET_H
#define CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_SITE_SET_H

#include <CGAL/license/Point_set_flow.h>

#include <bitset>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// Some of the points of a point set, with a bit for each, and the places of those that are in the set among them.
class Site_set {
  typedef std::uint64_t Word;
  static constexpr std::size_t width = 64;

  std::vector<Word> m_words;
  std::vector<std::uint32_t> m_before; // how many are in the words before each; empty if not known

public:
  /// An empty set of `n` points
  explicit Site_set(std::size_t n) : m_words((n + width - 1) / width, 0) {}

  bool contains(std::size_t site) const { return (m_words[site / width] >> site % width & 1) != 0; }

  /// \return whether the site is new
  bool insert(std::size_t site)
  {
    if (contains(site))
      return false;
    m_words[site / width] |= Word(1) << site % width;
    return true;
  }

  /// To be called after the last site is inserted.
  /// \return the sites, ascending
  std::vector<std::uint32_t> finish()
  {
    std::vector<std::uint32_t> sites;
    m_before.reserve(m_words.size());
    for (std::size_t w = 0; w < m_words.size(); ++w) {
      m_before.push_back(static_cast<std::uint32_t>(sites.size()));
      if (m_words[w] != 0)
        for (std::size_t bit = 0; bit < width; ++bit)
          if ((m_words[w] >> bit & 1) != 0)
            sites.push_back(static_cast<std::uint32_t>(w * width + bit));
    }
    return sites;
  }

  /// The number of those in the set that are before a site
  /// \pre `finish()` was called
  std::uint32_t place(std::size_t site) const
  {
    const Word below = m_words[site / width] & ((Word(1) << site % width) - 1);
    return m_before[site / width] + static_cast<std::uint32_t>(std::bitset<width>(below).count());
  }
};

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_NEIGHBORS_SITE_SET_H
