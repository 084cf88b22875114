// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_BLOCKS_EXCERPT_H
#define BALANCED_FLOW_BLOCKS_EXCERPT_H

#include "Manifest.h"
#include "Page_tree.h"
#include "smooth.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace balanced_flow_blocks {

/// Points that are at hand: those of some pages, and of others on which the result depends
class Excerpt : public balanced_flow_smooth::Halo {
  const Manifest& m_manifest;
  Page_tree m_tree;
  std::vector<std::size_t> m_required; // pages that are to be read
  std::vector<char> m_is_required;
  Records m_records;

public:
  std::vector<point_files::Point_3> points;
  std::vector<point_files::Vector_3> normals;
  std::vector<std::uint32_t> scans; // empty if all are of one
  std::vector<std::uint64_t> numbers;

  explicit Excerpt(const Manifest& manifest)
      : m_manifest(manifest), m_tree(manifest.pages), m_is_required(manifest.pages.size()),
        m_records(manifest.has_normals)
  {}

  double distance_to_missing(const point_files::Point_3& p) const override
  {
    return m_tree.distance_to_unread({p.x(), p.y(), p.z()});
  }
  void require(const point_files::Point_3& center, double radius) override
  {
    require_near(std::array<double, 3>{center.x(), center.y(), center.z()}, radius);
  }

  template <typename Place>
  void require_near(const Place& place, double distance)
  {
    m_tree.for_each_unread(place, distance, [&](std::size_t page) {
      if (!m_is_required[page])
        m_required.push_back(page);
      m_is_required[page] = 1;
    });
  }

  std::uint64_t number_of_required_points() const;

  /// Reads the pages that are required.
  void read_required();
  void read(std::size_t page);
};

} // namespace balanced_flow_blocks

#endif // BALANCED_FLOW_BLOCKS_EXCERPT_H
